#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/common/ring_log.h"
#include "core/control/servo_loop.h"
#include "core/geometry/pose_history.h"
#include "core/robot/kinematics.h"

namespace mirrorarm::station {

/// What the robot did, gathered from every servo cycle: where the flange was at any time of the last seconds,
/// how hard it was driven, and the black box. Control thread only.
class ServoDigest {
 public:
  /// `period` is the time that one command takes on the wire.
  ServoDigest(const robot::ArmDescription& arm, Seconds period);

  void add(const control::ServoState& state);

  /// Nullptr before the first cycle.
  [[nodiscard]] const control::ServoState* newest() const { return newest_ ? &*newest_ : nullptr; }
  /// Flange in base at `time`, as measured; nothing outside the last seconds.
  [[nodiscard]] std::optional<RigidTransform> flangeAt(TimePoint time) const;
  /// The measured joints of the last cycle not after `time`; the oldest kept where there is none.
  [[nodiscard]] robot::Joints jointsAt(TimePoint time) const;

  /// Largest speed and acceleration of each joint that went over the wire, and largest share of the force
  /// that is allowed, since the last take.
  struct Peaks {
    robot::Joints v_rad_s;
    robot::Joints a_rad_s2;
    std::optional<double> force_share;  ///< nothing where the robot tells no torques
  };
  [[nodiscard]] Peaks takePeaks();

  /// The last cycles, oldest first.
  [[nodiscard]] std::shared_ptr<const std::vector<control::ServoState>> blackBox() const;

 private:
  void notePeaks(const robot::Joints& v_rad_s);
  static constexpr std::size_t kCycles = 10'240;  ///< 10 s at 1 kHz
  robot::Kinematics kinematics_;
  const double period_s_;
  PoseHistory flange_;
  std::unique_ptr<RingLog<control::ServoState, kCycles>> cycles_;
  std::optional<control::ServoState> newest_;
  robot::Joints last_sent_v_rad_s_;  ///< empty while the robot was not driven
  Peaks peaks_;
};

}  // namespace mirrorarm::station
