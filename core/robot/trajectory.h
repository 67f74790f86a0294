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

/// Quintic pieces one after another, each joint its own polynomial; position, speed and acceleration are
/// continuous. Fixed size: it goes from the control thread to the servo thread through a mailbox.
class Trajectory {
 public:
  static constexpr int kMaxPieces = 32;

  Trajectory() = default;
  /// Rests at `q` from `start` on.
  static Trajectory rest(const Joints& q, TimePoint start);

  /// From `from` (at `start`) to rest at `goal`, as fast as every joint keeps `limits` of speed and
  /// acceleration (extremes of the polynomial, also for a moving start; its excursion stays within the joint
  /// ranges too), but not in less than `at_least`. Where the moving start makes it impossible to stay inside,
  /// the excess is the least one. Source: paper section 2.4.
  static Trajectory quintic(const MotionState& from, const Joints& goal, TimePoint start,
                            const MotionLimits& limits, Seconds at_least = Seconds(0.0));

  /// Through `waypoints` (a planned detour) to rest at the last. Each joint passes a way point between two
  /// moves in the same direction without resting. 1 to kMaxPieces way points; others are an error of the
  /// caller.
  static Trajectory through(const MotionState& from, std::span<const Joints> waypoints, TimePoint start,
                            const MotionLimits& limits, Seconds at_least = Seconds(0.0));

  /// State at `time`; before the start the first state, after the end rest at the last. Does not allocate.
  [[nodiscard]] MotionState at(TimePoint time) const noexcept;
  [[nodiscard]] TimePoint start() const noexcept { return start_; }
  [[nodiscard]] TimePoint end() const noexcept;
  [[nodiscard]] Seconds duration() const noexcept;
  [[nodiscard]] Joints goal() const noexcept;
  [[nodiscard]] bool valid() const noexcept { return piece_count_ > 0; }

 private:
  struct Piece {
    double duration_s = 0.0;
    std::array<Polynomial, kMaxJoints> joints{};  ///< of the time since the piece began
  };
  class Timing;
  std::array<Piece, kMaxPieces> pieces_{};
  int piece_count_ = 0;
  int joint_count_ = 0;
  TimePoint start_{};
};

}  // namespace mirrorarm::robot
