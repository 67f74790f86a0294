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

/// "host:port", or the host alone.
struct HostAddress {
  std::string host;
  std::uint16_t port = 0;
};
/// The error is the reason.
[[nodiscard]] Expected<HostAddress, std::string> hostAddressOf(const std::string& text,
                                                               std::uint16_t port_if_none);

/// A connection that never makes its thread wait, wait() aside. One thread; nothing but connect() allocates.
class TcpSocket {
 public:
  /// The error is why there is no connection within `patience`.
  [[nodiscard]] static Expected<TcpSocket, std::string> connect(const HostAddress& address, Seconds patience);
  /// No connection.
  TcpSocket() = default;
  /// Owns `socket`.
  explicit TcpSocket(int socket);
  ~TcpSocket();
  TcpSocket(TcpSocket&& other) noexcept;
  TcpSocket& operator=(TcpSocket&& other) noexcept;

  [[nodiscard]] bool isOpen() const noexcept { return socket_ >= 0; }
  void close() noexcept;
  /// Whether something is there to receive, be it the end, within `longest`.
  [[nodiscard]] bool wait(Seconds longest) const noexcept;
  /// Takes what is there into `into`, which has room; 0 when nothing is. The error is errno's, 0 where the
  /// other side has closed the line.
  [[nodiscard]] Expected<std::size_t, int> receive(std::span<std::byte> into) const noexcept;
  /// All of it or, where the line is full or broken, false: then a message may have been cut.
  [[nodiscard]] bool send(std::span<const std::byte> bytes) const noexcept;
  /// As much of it as the line takes now, be it nothing. The error is errno's.
  [[nodiscard]] Expected<std::size_t, int> sendSome(std::span<const std::byte> bytes) const noexcept;
  /// The system keeps no more than about so many bytes for a slow reader.
  void keepShort(int most_bytes) const noexcept;

 private:
  int socket_ = -1;
};

/// A door for connections (IPv4). One thread.
class TcpListener {
 public:
  /// Port 0 takes a free one. The error is the reason.
  [[nodiscard]] static Expected<TcpListener, std::string> open(const std::string& address,
                                                               std::uint16_t port);
  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }

  struct Caller {
    TcpSocket socket;
    std::uint32_t address = 0;  ///< 127.0.0.1 is 0x7F000001
  };
  /// Who waits at the door, if anybody does.
  [[nodiscard]] std::optional<Caller> accept() const noexcept;

 private:
  TcpListener(TcpSocket socket, int descriptor, std::uint16_t port)
      : socket_(std::move(socket)), descriptor_(descriptor), port_(port) {}
  TcpSocket socket_;
  int descriptor_ = -1;  ///< of socket_
  std::uint16_t port_ = 0;
};

}  // namespace mirrorarm::devices
