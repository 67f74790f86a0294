#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/devices/igtl_poses.h"

namespace mirrorarm::devices {

/// Where a tracker listens, "host:port"; the port is 18944 where none is given.
struct TrackerAddress {
  std::string host;
  std::uint16_t port = 18944;
};
/// The error is the reason.
[[nodiscard]] Expected<TrackerAddress, std::string> trackerAddressOf(const std::string& text);

/// Poses of another tracker over OpenIGTLink, as its client. One thread. The protocol knows neither password
/// nor encryption: for a network that belongs to the workstation alone.
class PoseReceiver {
 public:
  /// The error is why there is no connection within `patience`.
  [[nodiscard]] static Expected<PoseReceiver, std::string> connect(const TrackerAddress& address,
                                                                   Seconds patience);
  ~PoseReceiver();
  PoseReceiver(PoseReceiver&& other) noexcept;
  PoseReceiver& operator=(PoseReceiver&& other) noexcept;

  /// The poses that came within `patience`, in their order; none after a quiet time. The error is why nothing
  /// more will come: the tracker closed the line, or sent what cannot be trusted.
  [[nodiscard]] Expected<std::vector<ReceivedPose>, std::string> receive(Seconds patience);

 private:
  explicit PoseReceiver(int socket) : socket_(socket) {}
  int socket_ = -1;
  IgtlStream stream_;
};

}  // namespace mirrorarm::devices
