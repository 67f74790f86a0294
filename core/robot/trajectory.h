#pragma once

#include <array>
#include <span>

#include "core/common/time.h"
#include "core/robot/joints.h"
#include "core/robot/motion_limits.h"

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

  /// From `from` (at `start`) to rest at `goal`, as fast as every joint keeps `limits` of speed and acceleration
  /// (checked on the polynomial, also for a moving start). Source: paper section 2.4.
  static Trajectory quintic(const MotionState& from, const Joints& goal, TimePoint start,
                            const MotionLimits& limits);

  /// Through `waypoints` (a planned detour), resting at none but the last when the limits allow it.
  /// At most kMaxPieces way points; more are an error of the caller.
  static Trajectory through(const MotionState& from, std::span<const Joints> waypoints, TimePoint start,
                            const MotionLimits& limits);

  /// State at `time`; before the start the first state, after the end rest at the last. Does not allocate.
  [[nodiscard]] MotionState at(TimePoint time) const noexcept;
  [[nodiscard]] TimePoint start() const noexcept { return start_; }
  [[nodiscard]] TimePoint end() const noexcept;
  [[nodiscard]] Joints goal() const noexcept;
  [[nodiscard]] bool valid() const noexcept { return piece_count_ > 0; }

 private:
  struct Piece {
    double duration_s = 0.0;
    std::array<std::array<double, 6>, kMaxJoints> coefficients{};  ///< of (t - start of the piece), rising power
  };
  std::array<Piece, kMaxPieces> pieces_{};
  int piece_count_ = 0;
  int joint_count_ = 0;
  TimePoint start_{};
};

}  // namespace mirrorarm::robot
