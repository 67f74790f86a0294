#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/igtl_door.h"
#include "core/devices/igtl_target.h"

namespace mirrorarm::devices {

struct IgtlTrackingHostSettings {
  std::string address = "127.0.0.1";              ///< own; never the whole world's
  std::uint16_t port = kIgtlPort;                 ///< 0 takes a free one
  std::vector<std::string> allowed{"127.0.0.1"};  ///< hosts that may connect
};

struct IgtlTrackingHostReport {
  std::uint64_t told = 0;     ///< frames, once for each client
  std::uint64_t dropped = 0;  ///< frames that a slow client did not get, since a newer one was there
  std::uint64_t callers = 0;
  std::uint64_t turned_away = 0;  ///< strangers, and more clients than there is room for
};

/// Tells clients over OpenIGTLink how targets were seen. Nothing here waits: a client that does not take its
/// messages as fast as they come gets the newest frame when it has room again. What clients send is ignored.
/// One thread.
class IgtlTrackingHost {
 public:
  static constexpr std::size_t kMostClients = 8;

  /// The error is why the address cannot be had.
  [[nodiscard]] static Expected<std::unique_ptr<IgtlTrackingHost>, std::string> open(
      const IgtlTrackingHostSettings& settings);

  /// Lets in who waits, lets go who has hung up, and goes on with what a full line held up. Some fifty times
  /// a second.
  void greet();
  /// All targets of one frame.
  void tell(const std::vector<TargetReport>& frame);

  [[nodiscard]] std::size_t clients() const { return clients_.size(); }
  /// Whether some client has not taken all that it was told.
  [[nodiscard]] bool isBehind() const;
  [[nodiscard]] std::uint16_t port() const { return door_.port(); }
  [[nodiscard]] IgtlTrackingHostReport report() const;

 private:
  /// A line and what it had no room for.
  struct Client {
    TcpSocket socket;
    std::vector<std::byte> begun;  ///< the rest of a frame of which a part is on the line
    std::vector<std::byte> next;   ///< the newest frame behind it
  };
  explicit IgtlTrackingHost(IgtlDoor door) : door_(std::move(door)) {}
  void letIn();
  void listen(Client& client);
  void send(Client& client);
  void dismiss();

  IgtlDoor door_;
  std::vector<Client> clients_;
  std::vector<std::byte> frame_;
  IgtlTrackingHostReport report_;
};

}  // namespace mirrorarm::devices
