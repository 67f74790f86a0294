#include "core/devices/igtl_tracking_host.h"

#include <algorithm>
#include <utility>

namespace mirrorarm::devices {
namespace {

/// Of frames that wait in the system for a client: what lies there longer than a second is of no use.
constexpr int kLineRoom = 8192;
constexpr std::size_t kPiece = 4096;

}  // namespace

Expected<std::unique_ptr<IgtlTrackingHost>, std::string> IgtlTrackingHost::open(
    const IgtlTrackingHostSettings& settings) {
  auto door = IgtlDoor::open(settings.address, settings.port, settings.allowed);
  if (!door) return unexpected(door.error());
  return std::unique_ptr<IgtlTrackingHost>(new IgtlTrackingHost(std::move(*door)));
}

void IgtlTrackingHost::greet() {
  letIn();
  for (Client& client : clients_) {
    listen(client);
    send(client);
  }
  dismiss();
}

void IgtlTrackingHost::letIn() {
  auto socket = door_.accept();
  if (!socket) return;
  if (clients_.size() == kMostClients) return void(++report_.turned_away);
  ++report_.callers;
  socket->keepShort(kLineRoom);
  clients_.push_back({std::move(*socket), {}, {}});
}

/// What comes is ignored; that the line has ended is not.
void IgtlTrackingHost::listen(Client& client) {
  std::array<std::byte, kPiece> piece{};
  if (!client.socket.receive(piece)) client.socket.close();
}

void IgtlTrackingHost::tell(const std::vector<TargetReport>& frame) {
  frame_.clear();
  for (const TargetReport& report : frame) {
    const auto bytes = igtlBytes(report);
    frame_.insert(frame_.end(), bytes.begin(), bytes.end());
  }
  for (Client& client : clients_) {
    report_.dropped += client.next.empty() ? 0 : 1;
    client.next = frame_;
    send(client);
  }
  dismiss();
}

void IgtlTrackingHost::send(Client& client) {
  while (client.socket.isOpen()) {
    if (client.begun.empty()) {
      if (client.next.empty()) return;
      std::swap(client.begun, client.next);
      ++report_.told;
    }
    const auto sent = client.socket.sendSome(client.begun);
    if (!sent) return client.socket.close();
    client.begun.erase(client.begun.begin(), client.begun.begin() + static_cast<std::ptrdiff_t>(*sent));
    if (!client.begun.empty()) return;
  }
}

void IgtlTrackingHost::dismiss() {
  std::erase_if(clients_, [](const Client& client) { return !client.socket.isOpen(); });
}

bool IgtlTrackingHost::isBehind() const {
  return std::any_of(clients_.begin(), clients_.end(),
                     [](const Client& client) { return !client.begun.empty() || !client.next.empty(); });
}

IgtlTrackingHostReport IgtlTrackingHost::report() const {
  IgtlTrackingHostReport report = report_;
  report.turned_away += door_.strangers();
  return report;
}

}  // namespace mirrorarm::devices
