#include "core/devices/ipv4.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

namespace mirrorarm::devices {

Expected<std::uint32_t, std::string> ipv4Of(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (const int failed = ::getaddrinfo(host.c_str(), nullptr, &hints, &found))
    return unexpected("'" + host + "': " + ::gai_strerror(failed));
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, std::min<std::size_t>(sizeof address, found->ai_addrlen));
  return ntohl(address.sin_addr.s_addr);
}

sockaddr_in socketAddress(std::uint32_t address, std::uint16_t port) noexcept {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(address);
  place.sin_port = htons(port);
  return place;
}

bool readyWithin(int socket, short events, Seconds longest) noexcept {
  const double whole_s = std::floor(longest.count());
  const timespec patience{static_cast<time_t>(whole_s), static_cast<long>(1e9 * (longest.count() - whole_s))};
  pollfd watched{socket, events, 0};
  return ::ppoll(&watched, 1, &patience, nullptr) > 0;
}

}  // namespace mirrorarm::devices
