#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/devices/igtl_door.h"
#include "core/devices/igtl_robot_protocol.h"
#include "core/devices/tcp_socket.h"
#include "core/robot/arm_description.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

struct IgtlRobotHostSettings {
  std::string address = "127.0.0.1";              ///< own; never the whole world's
  std::uint16_t port = kIgtlPort;                 ///< 0 takes a free one
  std::vector<std::string> allowed{"127.0.0.1"};  ///< hosts that may connect
  bool allow_motion = false;                      ///< by whoever started the program: never by a message
  Seconds period{0.004};                          ///< of states and commands
  Seconds silent_after{0.100};
  Seconds oldest{0.050};  ///< state that a command may answer
  double start_tolerance_rad = 0.002;
};

/// Why a command was not taken.
enum class RobotRefusal : std::uint8_t {
  kNotAllowed,    ///< the host was started without motion
  kOutOfOrder,    ///< its sequence does not rise
  kTooOld,        ///< it answers a state of long ago
  kStopped,       ///< after a stop, before the client has acknowledged it by a halt
  kNotFromRest,   ///< the motion would begin elsewhere, or the arm still moves
  kBeyondLimits,  ///< of joint range or speed, or not as many angles as joints
};
inline constexpr std::size_t kRobotRefusals = 6;
/// "not_allowed", "out_of_order", ...
[[nodiscard]] std::string_view id(RobotRefusal refusal);

struct IgtlRobotHostReport {
  std::uint64_t states = 0;
  std::uint64_t commands = 0;  ///< taken
  std::array<std::uint64_t, kRobotRefusals> refused{};
  std::uint64_t callers = 0;
  std::uint64_t turned_away = 0;  ///< strangers, and second clients
  std::uint64_t stops = 0;        ///< because of silence, a fault of the robot or a command beyond the limits
};

/// Lends a robot to one client over OpenIGTLink: tells its state once a period and moves it on straight lines
/// from command to command. A client that falls silent or hangs up, a command beyond the arm's limits and a
/// fault of the robot brake it; it moves again only after the client has sent a halt, and from rest. One
/// thread, which is the robot's servo thread.
class IgtlRobotHost {
 public:
  /// `robot` outlives it. The error is why the address cannot be had.
  [[nodiscard]] static Expected<std::unique_ptr<IgtlRobotHost>, std::string> open(
      const IgtlRobotHostSettings& settings, const robot::ArmDescription& arm, robot::RobotLink& robot);

  /// Until asked to stop, or `longest` is over; then the robot is halted.
  void run(const std::stop_token& stop, Seconds longest);

  [[nodiscard]] std::uint16_t port() const { return door_.port(); }
  [[nodiscard]] IgtlRobotHostReport report() const;

 private:
  IgtlRobotHost(const IgtlRobotHostSettings& settings, const robot::ArmDescription& arm,
                robot::RobotLink& robot, IgtlDoor door);
  void cycle();
  void readRobot();
  void listen();
  void takeMessages();
  void greet();
  void hangUp();
  void take(const RobotCommandMessage& command);
  [[nodiscard]] std::optional<RobotRefusal> refusalOf(const RobotCommandMessage& command) const;
  [[nodiscard]] bool isWithinLimits(const robot::Joints& q_rad) const;
  void drive();
  void stop(robot::LinkFault fault);
  void tell();

  const IgtlRobotHostSettings settings_;
  robot::RobotLink& robot_;
  IgtlDoor door_;
  robot::Joints lower_rad_, upper_rad_, max_speed_rad_s_;

  TcpSocket client_;
  std::vector<std::byte> received_;
  TimePoint now_{}, next_state_at_{}, state_at_{};
  std::array<TimePoint, 64> told_at_{};  ///< of the last states, by their sequence
  RobotStateMessage state_;
  robot::LinkFault robot_fault_ = robot::LinkFault::kNoAnswer;
  robot::LinkFault stop_fault_ = robot::LinkFault::kNone;  ///< until the client has acknowledged it
  bool driving_ = false;
  TimePoint commanded_at_{};
  robot::Joints from_, to_, setpoint_;  ///< good while driving
  IgtlRobotHostReport report_;
};

}  // namespace mirrorarm::devices
