#include "core/devices/fri_link.h"

#include <algorithm>
#include <utility>

#include "core/devices/fri_joints.h"
#include "core/devices/ipv4.h"

namespace mirrorarm::devices {
namespace {

using robot::LinkFault;

constexpr int kMostAtOnce = 128;  // datagrams a cycle, however many a stranger sends

}  // namespace

Expected<std::unique_ptr<FriLink>, std::string> FriLink::open(const FriLinkSettings& settings) {
  const FriSettings& session = settings.session;
  if (session.gives_way == robot::GivesWay::kAtTool &&
      (!session.arm || session.arm->joints.size() != kFriJoints))
    return unexpected(std::string("giving way at the tool needs the description of an arm of seven joints"));
  std::optional<std::uint32_t> controller;
  if (!settings.controller.empty()) {
    const auto address = ipv4Of(settings.controller);
    if (!address) return unexpected(address.error());
    controller = *address;
  }
  auto socket = UdpSocket::open(settings.address, settings.port);
  if (!socket) return unexpected(socket.error());
  return std::unique_ptr<FriLink>(new FriLink(settings, std::move(*socket), controller));
}

FriLink::FriLink(FriLinkSettings settings, UdpSocket socket, std::optional<std::uint32_t> controller)
    : settings_(std::move(settings)),
      socket_(std::move(socket)),
      controller_(controller),
      session_(settings_.session) {}

void FriLink::awaitCycle(Seconds longest) noexcept {
  answer();
  fresh_ = false;
  if (Clock::now() - looked_at_ > settings_.session.silent_after) beginAnew();
  const TimePoint end = Clock::now() + toClock(longest);
  // A step of the servo loop stands for a period of the arm: nothing else that comes may make one.
  for (Seconds left = longest; !fresh_ && left > Seconds(0.0); left = end - Clock::now())
    if (socket_.wait(left)) takeAll();
  looked_at_ = Clock::now();
  if (!fresh_ && Clock::now() - arrived_at_ > settings_.session.silent_after) session_.silence();
  publish();
}

/// What has waited for so long is of the past, and the newest may have found no room behind it.
void FriLink::beginAnew() noexcept {
  std::array<std::byte, kFriMeasurementSize> bytes;
  for (int i = 0; i < kMostAtOnce && socket_.receive(bytes); ++i) ++statistics_.overtaken;
  session_.silence();
}

bool FriLink::isController(UdpPeer peer) const noexcept {
  return !controller_ || peer.address == *controller_;
}

void FriLink::takeAll() noexcept {
  std::array<std::byte, kFriMeasurementSize> bytes;
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto datagram = socket_.receive(bytes);
    if (!datagram) return;
    if (!isController(datagram->from)) {
      ++statistics_.foreign;
      continue;
    }
    const auto measurement = datagram->size > bytes.size()
                                 ? unexpected(FriRefusal::kLong)
                                 : friMeasurementOf(std::span(bytes).first(datagram->size));
    if (measurement) {
      take(*measurement, *datagram);
    } else {
      ++statistics_.refused;
      statistics_.last_refusal = measurement.error();
    }
  }
}

void FriLink::take(const FriMeasurement& measurement, const ReceivedDatagram& datagram) noexcept {
  if (!session_.take(measurement)) return;
  controller_ = datagram.from.address;
  peer_ = datagram.from;
  arrived_at_ = datagram.arrived_at;
  statistics_.overtaken += unanswered_ ? 1 : 0;
  fresh_ = unanswered_ = true;
  if (session_.elapsed_s() == 0.0) speed_.reset();
  speed_.add(jointsOf(measurement.q_rad), session_.elapsed_s());
  const TimePoint sent_at = sent_at_[measurement.reflected % sent_at_.size()];
  if (sent_at != TimePoint{}) statistics_.round_trip = arrived_at_ - sent_at;
}

Expected<robot::RobotState, LinkFault> FriLink::read() noexcept {
  if (!fresh_) return unexpected(LinkFault::kNoAnswer);
  if (const LinkFault fault = session_.fault(); fault != LinkFault::kNone) return unexpected(fault);
  const FriMeasurement& newest = session_.newest();
  return robot::RobotState{jointsOf(newest.q_rad), speed_.value(), jointsOf(newest.external_torque_nm),
                           arrived_at_};
}

Expected<void, LinkFault> FriLink::command(const robot::RobotCommand& command) noexcept {
  if (!fresh_) return unexpected(LinkFault::kNoAnswer);
  const auto taken = session_.command(command);
  answer();
  return taken;
}

void FriLink::halt() noexcept {
  session_.halt();
  answer();
}

void FriLink::answer() noexcept {
  if (!std::exchange(unanswered_, false)) return;
  const FriCommand command = session_.answer();
  std::array<std::byte, kFriCommandSize> bytes;
  encode(command, bytes);
  const TimePoint now = Clock::now();
  sent_at_[command.sequence % sent_at_.size()] = now;
  if (socket_.send(bytes, peer_)) ++statistics_.answered;
  statistics_.answer_delay = now - arrived_at_;
  statistics_.longest_answer_delay = std::max(statistics_.longest_answer_delay, statistics_.answer_delay);
}

void FriLink::publish() noexcept {
  const FriMeasurement& newest = session_.newest();
  statistics_.phase = session_.phase();
  statistics_.fall = session_.fall();
  statistics_.state = newest.state;
  statistics_.quality = newest.quality;
  statistics_.controller = newest.answers;
  statistics_.counts = session_.counts();
  statistics_.newest_sequence = newest.sequence;
  published_.put(statistics_);
}

std::optional<FriLinkStatistics> FriLink::takeStatistics() noexcept {
  const FriLinkStatistics* const news = published_.take();
  if (news == nullptr) return std::nullopt;
  return *news;
}

}  // namespace mirrorarm::devices
