#include "core/devices/udp_socket.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include "core/devices/ipv4.h"

namespace mirrorarm::devices {
namespace {

/// Only a mistaken or jumping calendar makes a datagram older than this, or younger than now.
constexpr Seconds kOldest{1.0};

/// The kernel stamps by the calendar; only the datagram's age is taken from it.
TimePoint arrivalOf(const timespec& stamp) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const Seconds age(static_cast<double>(now.tv_sec - stamp.tv_sec) +
                    1e-9 * static_cast<double>(now.tv_nsec - stamp.tv_nsec));
  return Clock::now() - toClock(std::clamp(age, Seconds(0.0), kOldest));
}

TimePoint arrivalOf(msghdr& message) {
  for (cmsghdr* each = CMSG_FIRSTHDR(&message); each != nullptr; each = CMSG_NXTHDR(&message, each))
    if (each->cmsg_level == SOL_SOCKET && each->cmsg_type == SCM_TIMESTAMPNS) {
      timespec stamp{};
      std::memcpy(&stamp, CMSG_DATA(each), sizeof stamp);
      return arrivalOf(stamp);
    }
  return Clock::now();
}

}  // namespace

Expected<UdpSocket, std::string> UdpSocket::open(const std::string& address, std::uint16_t port) {
  const auto number = ipv4Of(address);
  if (!number) return unexpected(number.error());
  const std::string place = address + ":" + std::to_string(port);
  UdpSocket socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), port);
  const int yes = 1;
  sockaddr_in bound = socketAddress(*number, port);
  socklen_t size = sizeof bound;
  if (socket.socket_ < 0 || ::setsockopt(socket.socket_, SOL_SOCKET, SO_TIMESTAMPNS, &yes, sizeof yes) != 0 ||
      ::bind(socket.socket_, reinterpret_cast<sockaddr*>(&bound), size) != 0 ||
      ::getsockname(socket.socket_, reinterpret_cast<sockaddr*>(&bound), &size) != 0)
    return unexpected(place + ": " + std::strerror(errno));
  socket.port_ = ntohs(bound.sin_port);
  return socket;
}

UdpSocket::~UdpSocket() {
  if (socket_ >= 0) ::close(socket_);
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), port_(other.port_) {}

UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(socket_, other.socket_);
  std::swap(port_, other.port_);
  return *this;
}

bool UdpSocket::wait(Seconds longest) const noexcept { return readyWithin(socket_, POLLIN, longest); }

std::optional<ReceivedDatagram> UdpSocket::receive(std::span<std::byte> into) const noexcept {
  sockaddr_in source{};
  std::byte beyond{};
  iovec pieces[2] = {{into.data(), into.size()}, {&beyond, 1}};
  alignas(cmsghdr) std::byte control[CMSG_SPACE(sizeof(timespec))];
  msghdr message{};
  message.msg_name = &source;
  message.msg_namelen = sizeof source;
  message.msg_iov = pieces;
  message.msg_iovlen = 2;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  const auto size = ::recvmsg(socket_, &message, 0);
  if (size < 0) return std::nullopt;
  return ReceivedDatagram{static_cast<std::size_t>(size),
                          {ntohl(source.sin_addr.s_addr), ntohs(source.sin_port)},
                          arrivalOf(message)};
}

bool UdpSocket::send(std::span<const std::byte> bytes, UdpPeer to) const noexcept {
  const sockaddr_in address = socketAddress(to.address, to.port);
  return ::sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address),
                  sizeof address) == static_cast<ssize_t>(bytes.size());
}

}  // namespace mirrorarm::devices
