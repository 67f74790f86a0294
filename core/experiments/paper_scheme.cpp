#include "core/experiments/paper_scheme.h"

#include <cmath>

#include "core/experiments/paper_figures.h"
#include "core/robot/kinematics.h"
#include "core/robot/trajectory.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::experiments {
namespace {

using robot::Joints;
using robot::Trajectory;

constexpr double kReplan_s = 0.040;
constexpr double kPlanning_s = 0.020;
constexpr double kFigure_s = 0.002;  // between two moments

TimePoint at(double time_s) { return TimePoint(std::chrono::hours(1)) + toClock(Seconds(time_s)); }

/// What the robot knows at `time_s`: how the target stood when the newest frame was exposed that has been
/// tracked by then.
Eigen::Vector3d knownShift(const FollowRunSettings& settings, const FollowRun& run, double time_s) {
  const double age_s = 0.5 * run.exposure_s + run.transfer_s + 1e-3 * paper::kMean_ms;
  const double exposed_s = std::floor((time_s - age_s) * settings.rate_hz) / settings.rate_hz;
  return settings.path(exposed_s);
}

}  // namespace

Expected<std::vector<FollowMoment>, std::string> followAsThePaper(const FollowRunSettings& settings,
                                                                  const FollowRun& run) {
  const auto arm = robot::readUrdf(settings.resources / "robots/lbr4plus.urdf");
  if (!arm) return unexpected(describe(arm.error()));
  const robot::Kinematics kinematics(*arm);
  const auto start = simulation::bench_layout::startPosture(kinematics);
  if (!start) return unexpected(std::string("the arm does not reach the bench's start pose"));
  const robot::MotionLimits limits = *robot::limitsOf("therapy", *arm);
  const RigidTransform X_BF_start = kinematics.flange(*start);
  std::vector<FollowMoment> moments;
  Trajectory motion = Trajectory::rest(*start, at(kFollowingFrom_s));
  Joints near = *start;
  double next_s = kFollowingFrom_s;
  for (double t = kFollowingFrom_s; t < settings.duration_s; t += kFigure_s) {
    if (t >= next_s) {
      next_s += kReplan_s;
      const auto goal =
          kinematics.inverse(Eigen::Translation3d(knownShift(settings, run, t)) * X_BF_start, near);
      if (!goal) return unexpected(std::string("the arm does not reach all of the path"));
      near = *goal;
      const TimePoint begin = at(t + kPlanning_s);
      motion = Trajectory::quintic(motion.at(begin), *goal, begin, limits);
    }
    const Eigen::Vector3d tool =
        kinematics.flange(motion.at(at(t - run.arm_delay_s)).q_rad).translation() - X_BF_start.translation();
    moments.push_back({t, settings.path(t), tool});
  }
  return moments;
}

}  // namespace mirrorarm::experiments
