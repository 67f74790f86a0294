#include "core/devices/pose_receiver.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace mirrorarm::devices {
namespace {

constexpr std::size_t kPiece = 4096;

int milliseconds(Seconds patience) { return static_cast<int>(1e3 * patience.count()); }

/// True when the socket is ready for `events` within the time.
bool waitFor(int socket, short events, Seconds patience) {
  pollfd watched{socket, events, 0};
  return ::poll(&watched, 1, milliseconds(patience)) > 0;
}

/// Connects without waiting for longer than `patience`; the error is errno's.
int connectWithin(int socket, const addrinfo& address, Seconds patience) {
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!waitFor(socket, POLLOUT, patience)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

Expected<TrackerAddress, std::string> trackerAddressOf(const std::string& text) {
  TrackerAddress address;
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

Expected<PoseReceiver, std::string> PoseReceiver::connect(const TrackerAddress& address, Seconds patience) {
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
    PoseReceiver receiver(
        ::socket(each->ai_family, each->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, each->ai_protocol));
    if (receiver.socket_ < 0) continue;
    error = connectWithin(receiver.socket_, *each, patience);
    if (error == 0) return receiver;
  }
  return unexpected(place + ": " + std::strerror(error));
}

PoseReceiver::~PoseReceiver() {
  if (socket_ >= 0) ::close(socket_);
}

PoseReceiver::PoseReceiver(PoseReceiver&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), stream_(std::move(other.stream_)) {}

PoseReceiver& PoseReceiver::operator=(PoseReceiver&& other) noexcept {
  std::swap(socket_, other.socket_);
  std::swap(stream_, other.stream_);
  return *this;
}

Expected<std::vector<ReceivedPose>, std::string> PoseReceiver::receive(Seconds patience) {
  if (!waitFor(socket_, POLLIN, patience)) return std::vector<ReceivedPose>{};
  std::array<std::byte, kPiece> piece{};
  const auto size = ::recv(socket_, piece.data(), piece.size(), 0);
  if (size == 0) return unexpected(std::string("the tracker has closed the line"));
  if (size < 0) {
    if (errno == EAGAIN || errno == EINTR) return std::vector<ReceivedPose>{};
    return unexpected(std::string(std::strerror(errno)));
  }
  stream_.add(std::span(piece).first(static_cast<std::size_t>(size)));
  std::vector<ReceivedPose> poses;
  while (true) {
    const auto message = stream_.next();
    if (!message) return unexpected("the tracker " + std::string(reason(message.error())));
    if (!*message) return poses;
    for (auto& pose : posesOf(**message)) poses.push_back(std::move(pose));
  }
}

}  // namespace mirrorarm::devices
