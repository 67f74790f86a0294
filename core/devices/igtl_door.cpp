#include "core/devices/igtl_door.h"

#include <algorithm>

#include "core/devices/ipv4.h"

namespace mirrorarm::devices {

Expected<IgtlDoor, std::string> IgtlDoor::open(const std::string& address, std::uint16_t port,
                                               const std::vector<std::string>& allowed) {
  std::vector<std::uint32_t> addresses;
  for (const std::string& host : allowed) {
    const auto number = ipv4Of(host);
    if (!number) return unexpected(number.error());
    addresses.push_back(*number);
  }
  auto listener = TcpListener::open(address, port);
  if (!listener) return unexpected(listener.error());
  return IgtlDoor(std::move(*listener), std::move(addresses));
}

std::optional<TcpSocket> IgtlDoor::accept() {
  auto caller = listener_.accept();
  if (!caller) return std::nullopt;
  if (std::find(allowed_.begin(), allowed_.end(), caller->address) != allowed_.end())
    return std::move(caller->socket);
  ++strangers_;
  return std::nullopt;
}

}  // namespace mirrorarm::devices
