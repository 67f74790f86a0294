#include <random>
#include <vector>

#include "benchmarks/robot/suite.h"
#include "benchmarks/timing.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using mirrorarm::robot::Joints;
using mirrorarm::robot::MotionLimits;
using mirrorarm::robot::MotionState;
using mirrorarm::robot::Trajectory;

constexpr int kJoints = 7;

/// The therapy profile of a seven-joint arm.
MotionLimits therapyLimits() {
  MotionLimits limits{Joints::Constant(kJoints, -2.9),
                      Joints::Constant(kJoints, 2.9),
                      Joints::Constant(kJoints, 0.24),
                      Joints::Constant(kJoints, 0.8),
                      Joints::Constant(kJoints, 40.0),
                      0.24,
                      0.8};
  limits.max_acceleration_rad_s2.head<2>().setConstant(0.5);
  return limits;
}

}  // namespace

void measureMotion(Run& run) {
  const int count = run.trials(20'000, 500);
  const MotionLimits limits = therapyLimits();
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> goal(-0.1, 0.1), speed(-0.1, 0.1);
  std::vector<MotionState> starts;
  std::vector<Joints> goals;
  for (int i = 0; i < count; ++i) {
    starts.push_back({Joints::Zero(kJoints), Joints::NullaryExpr(kJoints, [&] { return speed(random); }),
                      Joints::Zero(kJoints)});
    goals.push_back(Joints::NullaryExpr(kJoints, [&] { return goal(random); }));
  }
  const Timing quintic = timed(count, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    static_cast<void>(Trajectory::quintic(starts[k], goals[k], TimePoint{}, limits));
  });
  run.report.rows.push_back(
      {"",
       "The paper's quintic, timed for the limits",
       "",
       {{"median", 1000.0 * quintic.median_ms, "us"}, {"p99", 1000.0 * quintic.p99_ms, "us"}},
       {},
       {}});
}

}  // namespace mirrorarm::benchmarks::robot
