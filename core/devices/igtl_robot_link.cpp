#include "core/devices/igtl_robot_link.h"

#include <algorithm>
#include <thread>

namespace mirrorarm::devices {

using robot::LinkFault;

Expected<std::unique_ptr<IgtlRobotLink>, std::string> IgtlRobotLink::connect(const HostAddress& address,
                                                                             Seconds patience) {
  auto socket = TcpSocket::connect(address, patience);
  if (!socket) return unexpected(socket.error());
  std::unique_ptr<IgtlRobotLink> link(new IgtlRobotLink(std::move(*socket)));
  const TimePoint end = Clock::now() + toClock(patience);
  while (!link->known_ && link->socket_.isOpen() && Clock::now() < end) link->awaitCycle(end - Clock::now());
  const std::string place = address.host + ":" + std::to_string(address.port);
  if (!link->known_)
    return unexpected(place + (link->socket_.isOpen() ? ": tells of no robot" : ": has closed the line"));
  link->period_ = Seconds(link->state_.period_s);
  return link;
}

void IgtlRobotLink::awaitCycle(Seconds longest) noexcept {
  fresh_ = false;
  const TimePoint end = Clock::now() + toClock(longest);
  while (!fresh_ && socket_.isOpen()) {
    const Seconds left = end - Clock::now();
    if (left <= Seconds(0.0) || !socket_.wait(left)) return;
    takeAll();
  }
  // A line that is closed must not make its thread spin.
  if (!fresh_) std::this_thread::sleep_until(end);
}

void IgtlRobotLink::takeAll() noexcept {
  while (socket_.isOpen()) {
    const auto size = socket_.receive(std::span(received_).subspan(size_));
    if (!size) return socket_.close();
    if (*size == 0) return;
    size_ += *size;
    takeMessages();
    if (size_ == received_.size()) return socket_.close();  // a message that is none of ours
  }
}

void IgtlRobotLink::takeMessages() noexcept {
  std::span<const std::byte> rest = std::span(received_).first(size_);
  while (true) {
    const auto view = igtlView(rest);
    if (!view) return socket_.close();  // out of step: nothing after it can be believed
    if (!*view) break;
    const auto state = robotStateOf(**view);
    if (state && (!known_ || state->sequence > state_.sequence)) {
      state_ = *state;
      arrived_at_ = Clock::now();
      known_ = fresh_ = true;
    }
    rest = rest.subspan((*view)->size);
  }
  std::copy(rest.begin(), rest.end(), received_.begin());
  size_ = rest.size();
}

Expected<robot::RobotState, LinkFault> IgtlRobotLink::read() noexcept {
  if (!fresh_) return unexpected(LinkFault::kNoAnswer);
  if (state_.fault != LinkFault::kNone) return unexpected(LinkFault{state_.fault});
  return robot::RobotState{state_.q_rad, state_.v_rad_s, state_.external_torque_nm, arrived_at_};
}

Expected<void, LinkFault> IgtlRobotLink::command(const robot::RobotCommand& command) noexcept {
  if (!fresh_ || !socket_.isOpen()) return unexpected(LinkFault::kNoAnswer);
  if (state_.fault != LinkFault::kNone) return unexpected(LinkFault{state_.fault});
  if (!state_.takes_commands) return unexpected(LinkFault::kNotReady);
  if (command.q_rad.size() != state_.q_rad.size() || !command.q_rad.allFinite())
    return unexpected(LinkFault::kDriveFault);
  send({0, 0, true, command.q_rad});
  return {};
}

void IgtlRobotLink::halt() noexcept { send({}); }

void IgtlRobotLink::send(const RobotCommandMessage& command) noexcept {
  if (!socket_.isOpen() || !known_) return;
  RobotMessageBytes bytes;
  RobotCommandMessage numbered = command;
  numbered.sequence = ++sequence_;
  numbered.reflected = state_.sequence;
  if (!socket_.send(encode(numbered, bytes))) socket_.close();
}

}  // namespace mirrorarm::devices
