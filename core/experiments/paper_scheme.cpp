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

Eigen::Vector3d shiftAt(const FollowRunSettings& settings, double time_s) {
  return settings.path(time_s - kPhaseBehind_s);
}

/// What the robot knows at `time_s`: how the target stood when the newest frame was exposed that has been
/// tracked by then.
Eigen::Vector3d knownShift(const FollowRunSettings& settings, const FollowRun& run, double time_s) {
  const double age_s = 0.5 * run.exposure_s + run.transfer_s + 1e-3 * paper::kMean_ms;
  return shiftAt(settings, std::floor((time_s - age_s) * settings.rate_hz) / settings.rate_hz);
}

/// The commanded motion: the one before goes on until the new one begins.
class Commands {
 public:
  explicit Commands(const Joints& start) : now_(Trajectory::rest(start, at(kFollowingFrom_s))), next_(now_) {}

  [[nodiscard]] Joints jointsAt(double time_s) {
    if (next_.start() <= at(time_s)) now_ = next_;
    return now_.at(at(time_s)).q_rad;
  }
  void plan(const Joints& goal, double begin_s, const robot::MotionLimits& limits) {
    next_ = Trajectory::quintic(now_.at(at(begin_s)), goal, at(begin_s), limits);
  }

 private:
  Trajectory now_, next_;
};

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
  const auto delay = static_cast<std::size_t>(std::lround(run.arm_delay_s / kFigure_s));
  std::vector<Eigen::Vector3d> commanded;
  std::vector<FollowMoment> moments;
  Commands commands(*start);
  Joints near = *start;
  double next_s = kFollowingFrom_s;
  for (double t = kFollowingFrom_s; t < settings.duration_s; t += kFigure_s) {
    if (t >= next_s) {
      next_s += kReplan_s;
      const auto goal =
          kinematics.inverse(Eigen::Translation3d(knownShift(settings, run, t)) * X_BF_start, near);
      if (!goal) return unexpected(std::string("the arm does not reach all of the path"));
      near = *goal;
      commands.plan(*goal, t + kPlanning_s, limits);
    }
    commanded.push_back(kinematics.flange(commands.jointsAt(t)).translation() - X_BF_start.translation());
    const std::size_t late = commanded.size() > delay ? commanded.size() - 1 - delay : 0;
    moments.push_back({t, shiftAt(settings, t), commanded[late]});
  }
  return moments;
}

}  // namespace mirrorarm::experiments
