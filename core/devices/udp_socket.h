#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/common/expected.h"
#include "core/common/time.h"

namespace mirrorarm::devices {

/// Who sent a datagram (IPv4).
struct UdpPeer {
  std::uint32_t address = 0;  ///< 127.0.0.1 is 0x7F000001
  std::uint16_t port = 0;
  auto operator<=>(const UdpPeer&) const = default;
};

struct ReceivedDatagram {
  std::size_t size = 0;  ///< one more than there was room for, where it was longer
  UdpPeer from;
  TimePoint arrived_at{};  ///< at the machine's network door, not when it was read
};

/// A bound UDP socket (IPv4). One thread; after open() nothing allocates, and only wait() waits.
class UdpSocket {
 public:
  /// Port 0 takes a free one. The error is the reason.
  [[nodiscard]] static Expected<UdpSocket, std::string> open(const std::string& address, std::uint16_t port);
  ~UdpSocket();
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&& other) noexcept;

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  /// Whether a datagram came within `longest`.
  [[nodiscard]] bool wait(Seconds longest) const noexcept;
  /// The next datagram that is there.
  [[nodiscard]] std::optional<ReceivedDatagram> receive(std::span<std::byte> into) const noexcept;
  bool send(std::span<const std::byte> bytes, UdpPeer to) const noexcept;

 private:
  UdpSocket(int socket, std::uint16_t port) : socket_(socket), port_(port) {}
  int socket_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace mirrorarm::devices
