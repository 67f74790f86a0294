#include "core/devices/tcp_socket.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include "core/devices/ipv4.h"

namespace mirrorarm::devices {
namespace {

constexpr int kMostWaiting = 4;

/// Connects without waiting for longer than `patience`; the error is errno's.
int connectWithin(int socket, const addrinfo& address, Seconds patience) {
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!readyWithin(socket, POLLOUT, patience)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

Expected<HostAddress, std::string> hostAddressOf(const std::string& text, std::uint16_t port_if_none) {
  HostAddress address{"", port_if_none};
  const auto colon = text.rfind(':');
  address.host = text.substr(0, colon);
  if (address.host.empty()) return unexpected("'" + text + "' is not HOST:PORT");
  if (colon == std::string::npos) return address;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, address.port);
  if (error != std::errc() || stop != end || address.port == 0)
    return unexpected("'" + text + "' is not HOST:PORT");
  return address;
}

Expected<TcpSocket, std::string> TcpSocket::connect(const HostAddress& address, Seconds patience) {
  const std::string place = address.host + ":" + std::to_string(address.port);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int failed =
          ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found))
    return unexpected(place + ": " + ::gai_strerror(failed));
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
  int error = ECONNREFUSED;
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    const int descriptor =
        ::socket(each->ai_family, each->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, each->ai_protocol);
    if (descriptor < 0) continue;
    TcpSocket socket(descriptor);
    error = connectWithin(descriptor, *each, patience);
    if (error == 0) return socket;
  }
  return unexpected(place + ": " + std::strerror(error));
}

TcpSocket::TcpSocket(int socket) : socket_(socket) {
  const int yes = 1;  // each message is sent at once
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

TcpSocket::~TcpSocket() { close(); }

TcpSocket::TcpSocket(TcpSocket&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

TcpSocket& TcpSocket::operator=(TcpSocket&& other) noexcept {
  std::swap(socket_, other.socket_);
  return *this;
}

void TcpSocket::close() noexcept {
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
}

bool TcpSocket::wait(Seconds longest) const noexcept { return readyWithin(socket_, POLLIN, longest); }

Expected<std::size_t, int> TcpSocket::receive(std::span<std::byte> into) const noexcept {
  const auto size = ::recv(socket_, into.data(), into.size(), 0);
  if (size > 0) return static_cast<std::size_t>(size);
  if (size == 0) return unexpected(0);
  if (errno == EAGAIN || errno == EINTR) return std::size_t{0};
  return unexpected(int{errno});
}

bool TcpSocket::send(std::span<const std::byte> bytes) const noexcept {
  return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

Expected<std::size_t, int> TcpSocket::sendSome(std::span<const std::byte> bytes) const noexcept {
  const auto size = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (size >= 0) return static_cast<std::size_t>(size);
  if (errno == EAGAIN || errno == EINTR) return std::size_t{0};
  return unexpected(int{errno});
}

void TcpSocket::keepShort(int most_bytes) const noexcept {
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDBUF, &most_bytes, sizeof most_bytes);
}

Expected<TcpListener, std::string> TcpListener::open(const std::string& address, std::uint16_t port) {
  const auto number = ipv4Of(address);
  if (!number) return unexpected(number.error());
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  TcpSocket socket(descriptor);
  sockaddr_in bound = socketAddress(*number, port);
  socklen_t size = sizeof bound;
  const int yes = 1;
  if (descriptor < 0 || ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      ::bind(descriptor, reinterpret_cast<sockaddr*>(&bound), size) != 0 ||
      ::listen(descriptor, kMostWaiting) != 0 ||
      ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&bound), &size) != 0)
    return unexpected(address + ":" + std::to_string(port) + ": " + std::strerror(errno));
  return TcpListener(std::move(socket), descriptor, ntohs(bound.sin_port));
}

std::optional<TcpListener::Caller> TcpListener::accept() const noexcept {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  const int caller =
      ::accept4(descriptor_, reinterpret_cast<sockaddr*>(&address), &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (caller < 0) return std::nullopt;
  return Caller{TcpSocket(caller), ntohl(address.sin_addr.s_addr)};
}

}  // namespace mirrorarm::devices
