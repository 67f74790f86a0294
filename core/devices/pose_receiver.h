#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/devices/igtl_poses.h"
#include "core/devices/igtl_target.h"
#include "core/devices/tcp_socket.h"

namespace mirrorarm::devices {

/// Poses of another tracker over OpenIGTLink, as its client. One thread. The protocol knows neither password
/// nor encryption: for a network that belongs to the workstation alone.
class PoseReceiver {
 public:
  /// The error is why there is no connection within `patience`.
  [[nodiscard]] static Expected<PoseReceiver, std::string> connect(const HostAddress& address,
                                                                   Seconds patience);
  /// The poses that came within `patience`, in their order; none after a quiet time. The error is why nothing
  /// more will come: the tracker closed the line, or sent what cannot be trusted.
  [[nodiscard]] Expected<std::vector<ReceivedPose>, std::string> receive(Seconds patience);

  /// How often a tracker of ours has told a target as what, by TargetSight.
  [[nodiscard]] const std::array<std::uint64_t, 3>& sights() const { return sights_; }

 private:
  explicit PoseReceiver(TcpSocket socket) : socket_(std::move(socket)) {}
  TcpSocket socket_;
  IgtlStream stream_;
  std::array<std::uint64_t, 3> sights_{};
};

}  // namespace mirrorarm::devices
