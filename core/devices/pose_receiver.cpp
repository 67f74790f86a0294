#include "core/devices/pose_receiver.h"

#include <array>
#include <cstring>

namespace mirrorarm::devices {
namespace {

constexpr std::size_t kPiece = 4096;

}  // namespace

Expected<PoseReceiver, std::string> PoseReceiver::connect(const HostAddress& address, Seconds patience) {
  auto socket = TcpSocket::connect(address, patience);
  if (!socket) return unexpected(socket.error());
  return PoseReceiver(std::move(*socket));
}

Expected<std::vector<ReceivedPose>, std::string> PoseReceiver::receive(Seconds patience) {
  if (!socket_.wait(patience)) return std::vector<ReceivedPose>{};
  std::array<std::byte, kPiece> piece{};
  const auto size = socket_.receive(piece);
  if (!size && size.error() == 0) return unexpected(std::string("the tracker has closed the line"));
  if (!size) return unexpected(std::string(std::strerror(size.error())));
  stream_.add(std::span(piece).first(*size));
  std::vector<ReceivedPose> poses;
  while (true) {
    const auto message = stream_.next();
    if (!message) return unexpected("the tracker " + std::string(reason(message.error())));
    if (!*message) return poses;
    if (const auto report = targetReportOf(**message)) ++sights_[static_cast<std::size_t>(report->sight)];
    for (auto& pose : posesOf(**message)) poses.push_back(std::move(pose));
  }
}

}  // namespace mirrorarm::devices
