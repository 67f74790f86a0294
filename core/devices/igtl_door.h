#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/tcp_socket.h"

namespace mirrorarm::devices {

/// Where a host of ours waits for its clients. OpenIGTLink knows no password: only listed hosts come in,
/// strangers are hung up on without a word. One thread.
class IgtlDoor {
 public:
  /// Port 0 takes a free one. The error is the reason.
  [[nodiscard]] static Expected<IgtlDoor, std::string> open(const std::string& address, std::uint16_t port,
                                                            const std::vector<std::string>& allowed);

  /// A listed host that has come, if one has. Does not wait.
  [[nodiscard]] std::optional<TcpSocket> accept();
  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }
  [[nodiscard]] std::uint64_t strangers() const { return strangers_; }

 private:
  IgtlDoor(TcpListener listener, std::vector<std::uint32_t> allowed)
      : listener_(std::move(listener)), allowed_(std::move(allowed)) {}
  TcpListener listener_;
  std::vector<std::uint32_t> allowed_;
  std::uint64_t strangers_ = 0;
};

}  // namespace mirrorarm::devices
