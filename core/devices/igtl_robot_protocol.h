#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/devices/igtl_message.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

/// A robot over OpenIGTLink: two SENSOR messages, "RobotState" and "RobotCommand", whose numbers
/// docs/robot-links.md lists. Angles [rad].

/// Host to client, once a period.
struct RobotStateMessage {
  std::uint32_t sequence = 0;
  std::uint32_t heeded = 0;  ///< `sequence` of the command that was taken last
  robot::LinkFault fault = robot::LinkFault::kNone;
  bool takes_commands = false;  ///< the host was started to let clients move the robot
  double period_s = 0.0;
  robot::Joints q_rad;
  robot::Joints v_rad_s;
  robot::Joints external_torque_nm;  ///< empty where the robot does not feel
};

/// Client to host: the answer to one state.
struct RobotCommandMessage {
  std::uint32_t sequence = 0;
  std::uint32_t reflected = 0;  ///< `sequence` of the state that this answers: tells its age without clocks
  bool drive = false;           ///< false: brake to rest and forget the last stop
  robot::Joints q_rad;
};

inline constexpr std::size_t kMostRobotMessage = 512;
using RobotMessageBytes = std::array<std::byte, kMostRobotMessage>;

/// The message as it goes over the wire, inside `bytes`. Do not allocate.
[[nodiscard]] std::span<const std::byte> encode(const RobotStateMessage& state,
                                                RobotMessageBytes& bytes) noexcept;
[[nodiscard]] std::span<const std::byte> encode(const RobotCommandMessage& command,
                                                RobotMessageBytes& bytes) noexcept;
/// Nothing for other messages, other sizes, and numbers that are not finite or cannot be. Do not allocate.
[[nodiscard]] std::optional<RobotStateMessage> robotStateOf(const IgtlView& view) noexcept;
[[nodiscard]] std::optional<RobotCommandMessage> robotCommandOf(const IgtlView& view) noexcept;

/// A STATUS message: `code` 1 all is well, 5 denied, 15 disabled.
[[nodiscard]] IgtlMessage statusMessage(std::uint16_t code, const std::string& text);

}  // namespace mirrorarm::devices
