#include "core/devices/robot_address.h"

#include <cassert>
#include <string_view>

#include "core/devices/igtl_robot_link.h"

namespace mirrorarm::devices {
namespace {

constexpr std::string_view kFri = "fri:", kIgtl = "igtl:";

}  // namespace

Expected<RobotAddress, std::string> robotAddressOf(const std::string& text) {
  if (text == "simulated") return RobotAddress{};
  const auto refused = [&](const std::string&) {
    return "'" + text + "' is none of simulated, fri:[ADDRESS:]PORT, igtl:HOST[:PORT]";
  };
  const auto of = [](RobotAddress::Kind kind) {
    return [kind](const HostAddress& at) { return RobotAddress{kind, at}; };
  };
  if (text.starts_with(kIgtl))
    return hostAddressOf(text.substr(kIgtl.size()), kIgtlPort)
        .map(of(RobotAddress::Kind::kIgtl))
        .map_error(refused);
  if (!text.starts_with(kFri)) return unexpected(refused(text));
  std::string place = text.substr(kFri.size());
  if (place.find(':') == std::string::npos) place = FriLinkSettings{}.address + ":" + place;
  return hostAddressOf(place, kFriPort).map(of(RobotAddress::Kind::kFri)).map_error(refused);
}

Expected<std::unique_ptr<robot::RobotLink>, std::string> openRobot(const RobotAddress& address,
                                                                   const FriLinkSettings& fri,
                                                                   Seconds patience) {
  assert(address.kind != RobotAddress::Kind::kSimulated);
  if (address.kind == RobotAddress::Kind::kIgtl) {
    auto link = IgtlRobotLink::connect(address.at, patience);
    if (!link) return unexpected(link.error());
    return std::unique_ptr<robot::RobotLink>(std::move(*link));
  }
  FriLinkSettings settings = fri;
  settings.address = address.at.host;
  settings.port = address.at.port;
  auto link = FriLink::open(settings);
  if (!link) return unexpected(link.error());
  return std::unique_ptr<robot::RobotLink>(std::move(*link));
}

}  // namespace mirrorarm::devices
