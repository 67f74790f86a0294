#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/devices/udp_socket.h"
#include "core/peers/faulty_wire.h"
#include "core/peers/fri_controller.h"

namespace mirrorarm::peers {

struct FriControllerHostSettings {
  std::string host = "127.0.0.1";  ///< that is to answer
  std::uint16_t port = 49938;
  std::string address = "127.0.0.1";  ///< of its own
  FriControllerSettings controller{};
  std::vector<FriFault> faults;
  std::uint64_t seed = 1;
};

/// What of the faults happens to the controller itself at `time_s`, not to its datagrams.
void applyFaults(std::span<const FriFault> faults, double time_s, FriController& controller);

/// A FriController on a UDP socket at an even beat, over wires with faults. run() and what it changes belong
/// to one thread.
class FriControllerHost {
 public:
  /// The error is why the addresses cannot be had.
  [[nodiscard]] static Expected<std::unique_ptr<FriControllerHost>, std::string> open(
      const FriControllerHostSettings& settings, const robot::ArmDescription& arm,
      const robot::Joints& start);

  /// Until asked to stop, or `longest` is over. A beat that the machine slept through is skipped.
  void run(const std::stop_token& stop, Seconds longest);

  [[nodiscard]] const FriController& controller() const { return controller_; }
  /// Beats for which this thread came late by more than a cycle.
  [[nodiscard]] std::uint64_t skippedBeats() const { return skipped_beats_; }

 private:
  FriControllerHost(const FriControllerHostSettings& settings, const robot::ArmDescription& arm,
                    const robot::Joints& start, devices::UdpSocket socket, devices::UdpPeer host);
  void cycle(TimePoint now);
  void listenUntil(TimePoint due);

  const FriControllerHostSettings settings_;
  devices::UdpSocket socket_;
  devices::UdpPeer host_;
  FriController controller_;
  FaultyWire there_, back_;
  double time_s_ = 0.0;
  std::uint64_t skipped_beats_ = 0;
};

}  // namespace mirrorarm::peers
