#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/common/ring_log.h"
#include "core/control/servo_loop.h"
#include "core/geometry/pose_history.h"
#include "core/robot/kinematics.h"

namespace mirrorarm::station {

/// What the robot did, gathered from every servo cycle: where the flange was at any time of the last seconds, how
/// hard it was driven, and the black box. Control thread only.
class ServoDigest {
 public:
  explicit ServoDigest(const robot::ArmDescription& arm);

  void add(const control::ServoState& state);

  /// Nullptr before the first cycle.
  [[nodiscard]] const control::ServoState* newest() const { return newest_ ? &*newest_ : nullptr; }
  /// Flange in base at `time`, as measured; nothing outside the last seconds.
  [[nodiscard]] std::optional<RigidTransform> flangeAt(TimePoint time) const;
  /// The measured joints of the last cycle not after `time`; the oldest kept where there is none.
  [[nodiscard]] robot::Joints jointsAt(TimePoint time) const;

  /// Largest commanded speed and acceleration of each joint since the last take.
  struct Peaks {
    robot::Joints v_rad_s;
    robot::Joints a_rad_s2;
  };
  [[nodiscard]] Peaks takePeaks();

  /// The last cycles, oldest first.
  [[nodiscard]] std::shared_ptr<const std::vector<control::ServoState>> blackBox() const;

 private:
  static constexpr std::size_t kCycles = 2048;  ///< 10 s at 200 Hz
  robot::Kinematics kinematics_;
  PoseHistory flange_;
  std::unique_ptr<RingLog<control::ServoState, kCycles>> cycles_;
  std::optional<control::ServoState> newest_;
  Peaks peaks_;
};

}  // namespace mirrorarm::station
