#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>

#include "core/common/ring_log.h"
#include "core/common/time_source.h"
#include "core/robot/robot_link.h"
#include "core/simulation/joint_drives.h"

namespace mirrorarm::simulation {

/// Of an angle as the encoders give it, standard deviation.
inline constexpr double kAngleNoise_rad = 1e-5;

/// A robot arm that moves as its drives let it. Time passes for it when it is read or commanded; what it did
/// in the last seconds can be asked from other threads (one mutex, held for a copy).
class SimulatedRobot final : public robot::RobotLink {
 public:
  /// Rests at `start`. `time` outlives the robot.
  SimulatedRobot(const robot::ArmDescription& arm, const robot::Joints& start, const TimeSource& time,
                 std::uint64_t seed);

  /// Angles as the encoders give them, with their noise, and speeds as the drives regulate them; kNoAnswer
  /// while silent.
  [[nodiscard]] Expected<robot::RobotState, robot::LinkFault> read() noexcept override;
  /// kNoAnswer while silent: the robot then brakes by itself, as a controller does that has lost its host.
  /// kDriveFault for a wish that is not finite or has the wrong number of joints, which is ignored.
  [[nodiscard]] Expected<void, robot::LinkFault> command(const robot::RobotCommand& command) noexcept override;
  void halt() noexcept override;
  [[nodiscard]] Seconds period() const noexcept override { return JointDrives::kCycle; }

  /// Cuts the line in both directions. Any thread.
  void silence(bool silent) noexcept { silent_.store(silent, std::memory_order_relaxed); }

  /// True angles at `time`, interpolated; the oldest or newest where it lies outside the last seconds. Any
  /// thread.
  [[nodiscard]] robot::Joints jointsAt(TimePoint time) const;

 private:
  struct Moment {
    TimePoint time{};
    robot::Joints q;
  };
  void advance(TimePoint now) noexcept;
  void remember(TimePoint time) noexcept;

  const TimeSource& time_;
  JointDrives drives_;
  TimePoint advanced_to_;
  std::uint64_t seed_ = 0;
  std::uint64_t reading_ = 0;
  std::atomic<bool> silent_{false};
  mutable std::mutex mutex_;
  RingLog<Moment, 4096> history_;  ///< guarded by mutex_
};

}  // namespace mirrorarm::simulation
