#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/common/latest_value.h"
#include "core/devices/fri_session.h"
#include "core/devices/joint_speed.h"
#include "core/devices/udp_socket.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::devices {

inline constexpr std::uint16_t kFriPort = 49938;

struct FriLinkSettings {
  std::string address = "127.0.0.1";  ///< of this host on the controller's network
  std::uint16_t port = kFriPort;      ///< 0 takes a free one
  std::string controller;             ///< the only host that is answered; empty: the first that speaks FRI
  FriSettings session{};
};

/// How the line to the controller is, since it was opened.
struct FriLinkStatistics {
  FriPhase phase = FriPhase::kAbsent;
  FriFall fall = FriFall::kNone;  ///< the last
  FriState state = FriState::kOff;
  FriQuality quality = FriQuality::kUnacceptable;
  FriAnswerStatistics controller;  ///< by its own count
  FriSession::Counts counts;
  std::uint64_t answered = 0;
  std::uint64_t overtaken = 0;                   ///< not answered, since later ones were there already
  std::uint64_t refused = 0;                     ///< no datagrams of FRI
  FriRefusal last_refusal = FriRefusal::kShort;  ///< good where refused > 0
  std::uint64_t foreign = 0;                     ///< from other hosts
  std::uint16_t newest_sequence = 0;
  Seconds answer_delay{0.0};  ///< of the last answer, from the datagram's arrival at this machine
  Seconds longest_answer_delay{0.0};
  Seconds round_trip{0.0};  ///< from an answer to the arrival of the datagram that reflects it
};

/// The arm of an LBR 4+ over FRI 1.0 (UDP): answers every datagram of the controller from the servo thread,
/// mirroring while no commands come. The controller sets the pace. Whoever stays away for longer than
/// FriSettings::silent_after was silent to the controller and begins anew. See FriSession for what moves
/// when.
class FriLink final : public robot::RobotLink {
 public:
  /// The error is why the address cannot be had.
  [[nodiscard]] static Expected<std::unique_ptr<FriLink>, std::string> open(const FriLinkSettings& settings);

  /// kNoAnswer when nothing came in this cycle; after a fall its fault, until halt() was called.
  [[nodiscard]] Expected<robot::RobotState, robot::LinkFault> read() noexcept override;
  [[nodiscard]] Expected<void, robot::LinkFault> command(
      const robot::RobotCommand& command) noexcept override;
  /// Brakes within FriSettings::braking_rad_s2 and asks the program on the controller to stop.
  void halt() noexcept override;
  [[nodiscard]] Seconds period() const noexcept override { return settings_.session.period; }
  [[nodiscard]] bool setsThePace() const noexcept override { return true; }
  void awaitCycle(Seconds longest) noexcept override;
  [[nodiscard]] bool takesCommands() const noexcept override {
    return session_.phase() == FriPhase::kCommanding;
  }
  [[nodiscard]] robot::GivesWay givesWay() const noexcept override { return settings_.session.gives_way; }

  [[nodiscard]] std::uint16_t port() const noexcept { return socket_.port(); }
  /// News since the last call, once a cycle. One reader thread.
  [[nodiscard]] std::optional<FriLinkStatistics> takeStatistics() noexcept;

 private:
  FriLink(FriLinkSettings settings, UdpSocket socket, std::optional<std::uint32_t> controller);
  void beginAnew() noexcept;
  void takeAll() noexcept;
  [[nodiscard]] bool isController(UdpPeer peer) const noexcept;
  void take(const FriMeasurement& measurement, const ReceivedDatagram& datagram) noexcept;
  void answer() noexcept;
  void publish() noexcept;

  const FriLinkSettings settings_;
  UdpSocket socket_;
  std::optional<std::uint32_t> controller_;
  FriSession session_;
  JointSpeed speed_;
  UdpPeer peer_;
  TimePoint arrived_at_{};
  TimePoint looked_at_{};                ///< when the last awaitCycle() ended
  bool fresh_ = false;                   ///< a datagram came in this cycle
  bool unanswered_ = false;              ///< and waits for its answer
  std::array<TimePoint, 16> sent_at_{};  ///< of the last answers, by their sequence
  FriLinkStatistics statistics_;
  LatestValue<FriLinkStatistics> published_;
};

}  // namespace mirrorarm::devices
