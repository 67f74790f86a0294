#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "core/common/time_source.h"
#include "core/robot/kinematics.h"
#include "core/robot/robot_link.h"
#include "core/simulation/joint_drives.h"
#include "core/simulation/joint_trail.h"
#include "core/simulation/line_faults.h"
#include "core/simulation/sling_load.h"

namespace mirrorarm::simulation {

/// Of an angle as the encoders give it, standard deviation.
inline constexpr double kAngleNoise_rad = 1e-5;

/// Of a joint's outside torque as the robot tells it, standard deviation.
inline constexpr double kTorqueNoise_nm = 0.1;

struct SimulatedRobotSettings {
  std::uint64_t seed = 1;
  bool gives_way = false;                            ///< like springs in its joints; else it is stiff
  std::optional<SlingArm> load{};                    ///< nothing: it carries none and has no torque sensors
  Eigen::Vector3d p_FE_F = Eigen::Vector3d::Zero();  ///< where the load hangs, in the flange's frame
};

/// A robot arm that moves as its drives let it. Time passes for it when it is read or commanded; what it did
/// in the last seconds can be asked from other threads.
class SimulatedRobot final : public robot::RobotLink {
 public:
  /// Rests at `start`. `time` outlives the robot.
  SimulatedRobot(const robot::ArmDescription& arm, const robot::Joints& start, const TimeSource& time,
                 const SimulatedRobotSettings& settings);

  /// Angles and outside torques as the sensors give them, with their noise, and speeds as the drives regulate
  /// them; kNoAnswer while silent or when the line lost the answer.
  [[nodiscard]] Expected<robot::RobotState, robot::LinkFault> read() noexcept override;
  /// kNoAnswer while silent: the robot then brakes by itself, as a controller does that has lost its host.
  /// kDriveFault for a wish that is not finite or has the wrong number of joints, which is ignored.
  [[nodiscard]] Expected<void, robot::LinkFault> command(
      const robot::RobotCommand& command) noexcept override;
  void halt() noexcept override;
  [[nodiscard]] Seconds period() const noexcept override { return JointDrives::kCycle; }
  [[nodiscard]] robot::GivesWay givesWay() const noexcept override {
    return gives_way_ ? robot::GivesWay::kInJoints : robot::GivesWay::kNot;
  }

  /// Messages get lost or come late from now on. Any thread.
  void disturbLine(const LineFaults& faults) noexcept { line_.set(faults); }
  /// What hangs in the sling; nullptr where nothing does. Its setters are for any thread.
  [[nodiscard]] SlingLoad* load() noexcept { return load_ ? &*load_ : nullptr; }

  /// Cuts the line in both directions. Any thread.
  void silence(bool silent) noexcept { silent_.store(silent, std::memory_order_relaxed); }

  /// True angles at `time`, interpolated; the oldest or newest where it lies outside the last seconds. Any
  /// thread.
  [[nodiscard]] robot::Joints jointsAt(TimePoint time) const { return trail_.at(time); }

 private:
  void advance(TimePoint now) noexcept;
  void feelLoad() noexcept;
  [[nodiscard]] robot::RobotState sensed() noexcept;

  const TimeSource& time_;
  JointDrives drives_;
  TimePoint advanced_to_;
  const std::uint64_t seed_;
  const bool gives_way_;
  const Eigen::Vector3d p_FE_F_;
  std::optional<SlingLoad> load_;
  robot::Kinematics kinematics_;
  robot::Joints external_torque_nm_;  ///< of the load now; empty without one
  FaultyLine line_;
  std::uint64_t reading_ = 0, torque_reading_ = 0;
  robot::RobotState told_;  ///< the answer before
  std::atomic<bool> silent_{false};
  JointTrail trail_;
};

}  // namespace mirrorarm::simulation
