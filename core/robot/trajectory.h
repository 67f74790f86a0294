#pragma once

#include <array>
#include <span>

#include "core/common/time.h"
#include "core/robot/joints.h"
#include "core/robot/motion_limits.h"
#include "core/robot/polynomial.h"

namespace mirrorarm::robot {

/// Where a joint motion is at one time.
struct MotionState {
  Joints q_rad;
  Joints v_rad_s;
  Joints a_rad_s2;
};

/// Where a goal is and how fast it moves on.
struct MovingGoal {
  Joints q_rad;
  Joints v_rad_s;
};

/// How eagerly a moving goal is followed.
struct PursuitTimes {
  /// Small distances are caught up with evenly in this time, large ones as fast as the limits allow. Longer
  /// calms the noise of the goal, shorter follows closer.
  Seconds catch_up{0.0};
  /// A goal is believed to move on so long after the start; then the motion comes to rest.
  Seconds horizon{0.150};
};

/// A motion of all joints, each along polynomial pieces of its own; position, speed and acceleration are
/// continuous. It ends at rest. Fixed size: it goes from the control thread to the servo thread through a
/// mailbox. Nothing here allocates.
class Trajectory {
 public:
  static constexpr int kMaxPieces = 32;

  /// No motion: not valid().
  Trajectory() = default;
  /// Rests at `q` from `start` on.
  static Trajectory rest(const Joints& q, TimePoint start);

  /// From `from` (at `start`) to rest at `goal` on one quintic a joint, as fast as every joint keeps `limits`
  /// of speed, acceleration and jerk (extremes of the polynomial, also for a moving start; its excursion
  /// stays within the joint ranges too), but not in less than `at_least`. Where the moving start makes it
  /// impossible to stay inside, the excess is the least one. Source: paper section 2.4.
  static Trajectory quintic(const MotionState& from, const Joints& goal, TimePoint start,
                            const MotionLimits& limits, Seconds at_least = Seconds(0.0));

  /// Through `waypoints` (a planned detour) to rest at the last. Each joint passes a way point between two
  /// moves in the same direction without resting. 1 to kMaxPieces way points; others are an error of the
  /// caller.
  static Trajectory through(const MotionState& from, std::span<const Joints> waypoints, TimePoint start,
                            const MotionLimits& limits, Seconds at_least = Seconds(0.0));

  /// From any state onto a goal that moves evenly: it is met, not trailed, and then accompanied until the
  /// horizon; a goal at rest is simply reached. All joints keep `limits` of speed, acceleration and jerk. As
  /// seen from the goal each joint moves to rest at zero, on a quintic where that keeps the limits within the
  /// time that the slowest joint needs, else with jerk-limited pieces in the least time. A goal faster than
  /// the limits, or about to leave the joint ranges, is taken to be slower.
  static Trajectory pursuit(const MotionState& from, const MovingGoal& goal, TimePoint start,
                            const MotionLimits& limits, const PursuitTimes& times = {});

  /// State at `time`; before the start the first state, after the end rest at the last.
  [[nodiscard]] MotionState at(TimePoint time) const noexcept;
  [[nodiscard]] TimePoint start() const noexcept { return start_; }
  [[nodiscard]] TimePoint end() const noexcept { return start_ + toClock(duration()); }
  [[nodiscard]] Seconds duration() const noexcept;
  /// Where it ends.
  [[nodiscard]] Joints goal() const noexcept;
  [[nodiscard]] bool valid() const noexcept { return joint_count_ > 0; }

 private:
  struct Piece {
    double duration_s = 0.0;
    Polynomial position{};  ///< of the time since the piece began
  };
  struct JointMotion {
    std::array<Piece, kMaxPieces> pieces{};
    int piece_count = 0;
    void append(double duration_s, const Polynomial& position) noexcept;
    [[nodiscard]] double duration() const noexcept;
    [[nodiscard]] EndState at(double t) const noexcept;
  };
  class Timing;
  class Pursuit;
  Trajectory(Eigen::Index joints, TimePoint start) : joint_count_(static_cast<int>(joints)), start_(start) {}
  [[nodiscard]] JointMotion& joint(Eigen::Index j) noexcept { return joints_[static_cast<std::size_t>(j)]; }
  [[nodiscard]] const JointMotion& joint(Eigen::Index j) const noexcept {
    return joints_[static_cast<std::size_t>(j)];
  }

  std::array<JointMotion, kMaxJoints> joints_{};
  int joint_count_ = 0;
  TimePoint start_{};
};

}  // namespace mirrorarm::robot
