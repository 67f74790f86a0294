#pragma once

#include <memory>
#include <string>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/devices/fri_link.h"
#include "core/devices/tcp_socket.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

/// Which robot somebody wants, by a word: "simulated", "fri:[ADDRESS:]PORT" (own address and port that the
/// controller's datagrams come to) or "igtl:HOST[:PORT]" (another host that serves its robot).
struct RobotAddress {
  enum class Kind { kSimulated, kFri, kIgtl };
  Kind kind = Kind::kSimulated;
  HostAddress at;
};
/// The error is the reason.
[[nodiscard]] Expected<RobotAddress, std::string> robotAddressOf(const std::string& text);

/// The link to a robot that is not simulated. `fri` is what a link over FRI goes by, its own address and port
/// aside. The error is why there is none within `patience`.
[[nodiscard]] Expected<std::unique_ptr<robot::RobotLink>, std::string> openRobot(const RobotAddress& address,
                                                                                 const FriLinkSettings& fri,
                                                                                 Seconds patience);

}  // namespace mirrorarm::devices
