#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/common/expected.h"
#include "core/devices/fri_settings.h"
#include "core/devices/fri_tool_pose.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

/// Where a session stands.
enum class FriPhase : std::uint8_t {
  kAbsent,      ///< nothing has come yet, or not for long
  kMonitoring,  ///< the controller holds the arm; the host mirrors
  kStarting,    ///< the host wishes to move and has asked the program to start
  kCommanding,
  kStopping,  ///< the host brakes and has asked the program to stop
  kFallen,    ///< something went wrong; nothing is started before halt() was called
};
/// "absent", "monitoring", ...
[[nodiscard]] std::string_view id(FriPhase phase);

/// Why a session fell.
enum class FriFall : std::uint8_t {
  kNone,
  kSilence,
  kLostDatagrams,  ///< more in a row than the controller bridges, or a sequence that began anew
  kPoorQuality,    ///< by the controller's own judgement
  kDriveError,     ///< some drive reports an error
  kDrivesOff,      ///< while they were needed
  kLeftCommand,    ///< the controller went back to monitoring by itself
  kNotStarted,     ///< the program on the controller did not start in time
  kWrongControl,   ///< it starts another kind of control than was asked for
  kWrongPeriod,    ///< its cycle is not settings.period
  kStartPose,      ///< the motion would begin elsewhere than where the controller holds the arm
  kMovedEarly,     ///< the motion began before the controller took commands
  kWrongCommand,   ///< not seven finite angles, or a jump beyond the joints' speeds
};
/// "none", "silence", "lost_datagrams", ...
[[nodiscard]] std::string_view id(FriFall fall);
[[nodiscard]] robot::LinkFault linkFaultOf(FriFall fall);

/// The host's side of the Fast Research Interface without its socket: what to answer to each datagram. A
/// cycle is take(), then command() or halt() or neither, then answer(). One thread; does not allocate.
///
/// While the controller monitors, the answers mirror what it holds, as it demands. Commands that rest there
/// are taken at once and make the program start; once it has, and the settling time is over, commands move
/// the arm. They are shifted by the small difference between where the controller holds the arm and where the
/// motion begins, so that the first one equals what it holds. A cycle without a command brakes to rest.
/// Whatever goes wrong is answered by braking and a request to stop, and the session stays fallen until
/// halt() is called: it never goes on by itself.
class FriSession {
 public:
  /// Giving way at the tool needs settings.arm.
  explicit FriSession(const FriSettings& settings);

  /// A datagram; false for one that came twice, out of order or with a jump of the arm, which is only
  /// counted.
  bool take(const FriMeasurement& measurement) noexcept;
  /// Nothing came for settings.silent_after.
  void silence() noexcept;

  [[nodiscard]] Expected<void, robot::LinkFault> command(const robot::RobotCommand& command) noexcept;
  void halt() noexcept;
  /// The answer to the newest datagram. Once a datagram.
  [[nodiscard]] FriCommand answer() noexcept;

  [[nodiscard]] FriPhase phase() const noexcept { return phase_; }
  /// Why it has fallen, kept until it fell again.
  [[nodiscard]] FriFall fall() const noexcept { return fall_; }
  /// What a reader of the robot's state is to be told.
  [[nodiscard]] robot::LinkFault fault() const noexcept;
  [[nodiscard]] const FriMeasurement& newest() const noexcept { return newest_; }
  /// From the datagram before the newest to it [s]; 0 for the first.
  [[nodiscard]] double elapsed_s() const noexcept { return elapsed_s_; }

  struct Counts {
    std::uint64_t taken = 0;
    std::uint64_t lost = 0;
    std::uint64_t duplicated = 0;
    std::uint64_t reordered = 0;
    std::uint64_t implausible = 0;  ///< measured angles that the arm cannot have reached
    std::uint64_t falls = 0;
  };
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  [[nodiscard]] bool isNews(const FriMeasurement& measurement) noexcept;
  [[nodiscard]] bool isPossible(const FriMeasurement& measurement, int cycles) const noexcept;
  void watch() noexcept;
  void waitForStart() noexcept;
  void enterCommand() noexcept;
  void fallBy(FriFall reason) noexcept;
  [[nodiscard]] FriFall takeWish(const robot::Joints& q_rad) noexcept;
  [[nodiscard]] FriFall beginAt(const robot::Joints& q_rad) noexcept;
  [[nodiscard]] bool controllerMoves() const noexcept;
  [[nodiscard]] bool programIsReady() const noexcept;
  void mirror() noexcept;
  void brake() noexcept;
  void takeCompliance(const robot::Compliance& wish) noexcept;
  void fillImpedance(FriCommand& answer) const noexcept;

  const FriSettings settings_;
  std::optional<FriToolPose> tool_pose_;  ///< where the arm gives way at the tool
  FriPhase phase_ = FriPhase::kAbsent;
  FriFall fall_ = FriFall::kNone;
  FriMeasurement newest_;
  Counts counts_;
  bool in_step_ = false;  ///< the next datagram continues a sequence
  int disbelieved_in_a_row_ = 0;
  double elapsed_s_ = 0.0;

  std::uint16_t sent_sequence_ = 0;
  double unsent_s_ = 0.0;    ///< since `held_` was sent
  robot::Joints held_;       ///< what was sent last, or what the controller holds
  robot::Joints speed_;      ///< of what was sent last [rad/s]
  robot::Joints wished_;     ///< the newest command, not yet shifted
  robot::Joints beginning_;  ///< the first command since the arm was at rest
  robot::Joints shift_;      ///< from the commands to what is sent
  bool commanded_ = false;   ///< since the newest datagram
  bool asked_ = false;       ///< the program was asked to start
  bool entered_ = false;     ///< and has started
  double waited_s_ = 0.0;    ///< for the program to start; then for the arm to settle
  robot::Compliance compliance_ = settings_.compliance;
};

}  // namespace mirrorarm::devices
