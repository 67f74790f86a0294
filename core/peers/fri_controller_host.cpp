#include "core/peers/fri_controller_host.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/devices/ipv4.h"

namespace mirrorarm::peers {
namespace {

constexpr std::uint16_t kFailingDrive = 0x04;
constexpr double kMisplaced_rad = 0.1;
constexpr std::size_t kLargestDatagram = 1500;

}  // namespace

void applyFaults(std::span<const FriFault> faults, double time_s, FriController& controller) {
  const auto happens = [&](FriFaultKind kind) {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const FriFault& fault) { return fault.kind == kind && fault.isActive(time_s); });
  };
  controller.failDrives(happens(FriFaultKind::kDriveError) ? kFailingDrive : 0);
  controller.limitQuality(happens(FriFaultKind::kPoorQuality) ? devices::FriQuality::kBad
                                                              : devices::FriQuality::kPerfect);
  controller.misplaceHold(happens(FriFaultKind::kStartPose) ? kMisplaced_rad : 0.0);
}

Expected<std::unique_ptr<FriControllerHost>, std::string> FriControllerHost::open(
    const FriControllerHostSettings& settings, const robot::ArmDescription& arm, const robot::Joints& start) {
  const auto host = devices::ipv4Of(settings.host);
  if (!host) return unexpected(host.error());
  auto socket = devices::UdpSocket::open(settings.address, 0);
  if (!socket) return unexpected(socket.error());
  return std::unique_ptr<FriControllerHost>(
      new FriControllerHost(settings, arm, start, std::move(*socket), {*host, settings.port}));
}

FriControllerHost::FriControllerHost(const FriControllerHostSettings& settings,
                                     const robot::ArmDescription& arm, const robot::Joints& start,
                                     devices::UdpSocket socket, devices::UdpPeer host)
    : settings_(settings),
      socket_(std::move(socket)),
      host_(host),
      controller_(arm, start, settings.controller),
      there_(settings.faults, false, settings.seed),
      back_(settings.faults, true, settings.seed + 1) {}

void FriControllerHost::run(const std::stop_token& stop, Seconds longest) {
  const Clock::duration period = toClock(settings_.controller.period);
  TimePoint due = Clock::now();
  const double end_s = time_s_ + longest.count();
  while (!stop.stop_requested() && time_s_ < end_s) {
    cycle(Clock::now());
    due += period;
    listenUntil(due);
    if (const auto behind = Clock::now() - due; behind > period) {
      skipped_beats_ += static_cast<std::uint64_t>(behind / period);
      due += behind;
    }
  }
}

void FriControllerHost::cycle(TimePoint now) {
  applyFaults(settings_.faults, time_s_, controller_);
  std::array<std::byte, devices::kFriMeasurementSize> bytes;
  encode(controller_.cycle(now), bytes);
  there_.put(bytes, time_s_);
  for (const Datagram& each : there_.take()) socket_.send(each, host_);
  there_.endCycle();
  back_.endCycle();
  time_s_ += settings_.controller.period.count();
}

void FriControllerHost::listenUntil(TimePoint due) {
  std::array<std::byte, kLargestDatagram> bytes;
  for (;;) {
    while (const auto datagram = socket_.receive(bytes)) {
      back_.put(std::span(bytes).first(std::min(datagram->size, bytes.size())), time_s_);
      for (const Datagram& each : back_.take()) controller_.answer(each, datagram->arrived_at);
    }
    const auto left = due - Clock::now();
    if (left <= Clock::duration::zero()) return;
    static_cast<void>(socket_.wait(left));
  }
}

}  // namespace mirrorarm::peers
