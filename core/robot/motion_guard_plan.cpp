#include "core/robot/motion_guard_plan.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kToolShare = 0.97;  // of the tool's acceleration, for what its path bends further on
constexpr double kLeastShare = 0.2;  // of it, however much the path bends
constexpr double kRounding = 1e-9;
constexpr int kRounds = 4;
constexpr int kMostCycles = 1 << 20;

int wholeCycles(double cycles) {
  return static_cast<int>(std::ceil(std::clamp(cycles - kRounding, 0.0, static_cast<double>(kMostCycles))));
}

double largestShare(const Joints& numbers, const Joints& limits) {
  return (numbers.array().abs() / limits.array()).maxCoeff();
}

/// One search: the lengths of the parts depend on the plateau and the plateau on them.
class Search {
 public:
  Search(const MotionState& start, const ToolMotion& tool, double period_s, const MotionLimits& limits)
      : period_s_(period_s), limits_(limits), tool_(tool), v_(start.v_rad_s), a_(start.a_rad_s2) {}

  Stop run(bool release) {
    if (release) releaseFirst();
    stop_.ramp_in = stop_.ramp_out = 1;
    for (int round = 0; round < kRounds; ++round) {
      settleHold();
      settleRamps();
    }
    settleHold();
    return stop_;
  }

 private:
  void releaseFirst() {
    stop_.release = wholeCycles(largestShare(a_, limits_.max_jerk_rad_s3) / period_s_);
    if (stop_.release == 0) return;
    v_ += 0.5 * period_s_ * (stop_.release - 1) * a_;
    start_.speed[1] = 0.5 * period_s_ * (stop_.release - 1);
    start_.acceleration.setZero();
    a_.setZero();
  }

  /// Speed that the plateau has to take away, in units of acceleration times cycles.
  [[nodiscard]] Joints toTakeAway() const { return v_ / period_s_ + 0.5 * (stop_.ramp_in - 1) * a_; }
  [[nodiscard]] double ramps() const { return 0.5 * (stop_.ramp_in + stop_.ramp_out); }

  void settleHold() {
    const Joints speed = toTakeAway();
    const double by_acceleration = largestShare(speed, limits_.max_acceleration_rad_s2);
    const double by_jerk = std::sqrt(largestShare(speed, limits_.max_jerk_rad_s3) / period_s_);
    stop_.hold = wholeCycles(std::max({by_acceleration, by_jerk, byTool()}) - ramps());
    plateau_ = -speed / (ramps() + stop_.hold);
  }

  void settleRamps() {
    const double per_cycle = 1.0 / period_s_;
    stop_.ramp_in =
        std::max(1, wholeCycles(largestShare(plateau_ - a_, limits_.max_jerk_rad_s3) * per_cycle));
    stop_.ramp_out = std::max(1, wholeCycles(largestShare(plateau_, limits_.max_jerk_rad_s3) * per_cycle));
  }

  /// The least equivalent cycles of plateau for which the flange's acceleration is small enough at its
  /// beginning, where the path's bend counts most, and at its end, where the path has turned furthest. In
  /// between it changes evenly.
  [[nodiscard]] double byTool() const {
    Moment moving = start_;
    moving.speed += 0.5 * period_s_ * (stop_.ramp_in - 1) * moving.acceleration;
    moving.acceleration.setZero();
    const Eigen::Vector3d w = tool_.speed(moving), bend = tool_.acceleration(moving);
    const double speed = w.norm(), most = kToolShare * limits_.max_tool_acceleration_m_s2;
    if (speed < kRounding) return 0.0;
    const double along = bend.dot(w) / speed;
    const double across = std::max(0.0, bend.squaredNorm() - along * along);
    const double root = std::sqrt(std::max(0.0, most * most - across));
    const double at_first = speed / std::max(along + root, kLeastShare * most);
    const double at_last = (w + 0.5 * at_first * bend).norm() / most;
    return std::max(at_first, at_last) / period_s_;
  }

  double period_s_;
  const MotionLimits& limits_;
  const ToolMotion& tool_;
  Moment start_;
  Joints v_, a_, plateau_;
  Stop stop_;
};

}  // namespace

std::array<Stop, 2> planStops(const MotionState& start, const ToolMotion& tool, double period_s,
                              const MotionLimits& limits) {
  return {Search(start, tool, period_s, limits).run(false), Search(start, tool, period_s, limits).run(true)};
}

}  // namespace mirrorarm::robot
