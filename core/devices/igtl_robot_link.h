#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "core/devices/igtl_robot_protocol.h"
#include "core/devices/tcp_socket.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

/// A robot that another host drives (`mirrorarm-cli serve robot`), over OpenIGTLink. That host sets the pace
/// with its states; its robot brakes when this one falls silent. Once the line is closed it stays so.
class IgtlRobotLink final : public robot::RobotLink {
 public:
  /// Also waits for the first state. The error is why there is none within `patience`.
  [[nodiscard]] static Expected<std::unique_ptr<IgtlRobotLink>, std::string> connect(
      const HostAddress& address, Seconds patience);

  [[nodiscard]] Expected<robot::RobotState, robot::LinkFault> read() noexcept override;
  /// kNotReady where the host was not started to let clients move the robot.
  [[nodiscard]] Expected<void, robot::LinkFault> command(
      const robot::RobotCommand& command) noexcept override;
  void halt() noexcept override;
  [[nodiscard]] Seconds period() const noexcept override { return period_; }
  [[nodiscard]] bool setsThePace() const noexcept override { return true; }
  void awaitCycle(Seconds longest) noexcept override;
  [[nodiscard]] int jointCount() const { return static_cast<int>(state_.q_rad.size()); }

 private:
  explicit IgtlRobotLink(TcpSocket socket) : socket_(std::move(socket)) {}
  void takeAll() noexcept;
  void takeMessages() noexcept;
  void send(const RobotCommandMessage& command) noexcept;

  TcpSocket socket_;
  std::array<std::byte, 16384> received_{};
  std::size_t size_ = 0;  ///< of what was received and is not yet a whole message
  RobotStateMessage state_;
  TimePoint arrived_at_{};
  bool known_ = false, fresh_ = false;
  std::uint32_t sequence_ = 0;
  Seconds period_{0.0};
};

}  // namespace mirrorarm::devices
