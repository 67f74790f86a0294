#include "core/peers/faulty_wire.h"

#include <algorithm>
#include <utility>

#include "core/devices/fri_datagram.h"

namespace mirrorarm::peers {
namespace {

constexpr int kLateCycles = 2;
constexpr std::size_t kLeastGarbled = 16;
constexpr std::size_t kIdAt = 6, kMeasuredAngleAt = 216, kCommandedAngleAt = 144;
constexpr std::byte kNotANumber{0xFF};

}  // namespace

FaultyWire::FaultyWire(std::span<const FriFault> faults, bool carries_answers, std::uint64_t seed)
    : carries_answers_(carries_answers), random_(seed) {
  std::copy_if(faults.begin(), faults.end(), std::back_inserter(faults_), [&](const FriFault& fault) {
    return fault.kind == FriFaultKind::kSilence ||
           (fault.kind < FriFaultKind::kSilence && fault.to_answers == carries_answers);
  });
}

bool FaultyWire::happens(const FriFault& fault, double time_s) {
  return fault.isActive(time_s) && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < fault.share;
}

void FaultyWire::put(std::span<const std::byte> bytes, double time_s) {
  Datagram datagram(bytes.begin(), bytes.end());
  bool lost = false, doubled = false, behind_next = false;
  int late = 0;
  for (const FriFault& fault : faults_) {
    if (!happens(fault, time_s)) continue;
    lost = lost || fault.kind == FriFaultKind::kLost || fault.kind == FriFaultKind::kSilence;
    doubled = doubled || fault.kind == FriFaultKind::kDuplicated;
    behind_next = behind_next || fault.kind == FriFaultKind::kReordered;
    if (fault.kind == FriFaultKind::kLate) late = kLateCycles;
    spoil(fault.kind, datagram);
  }
  if (lost) return;
  if (late > 0 || behind_next) {
    delayed_.push_back({late, behind_next && late == 0, std::move(datagram)});
    return;
  }
  if (doubled) ready_.push_back(datagram);
  ready_.push_back(std::move(datagram));
  for (Delayed& each : delayed_)
    if (std::exchange(each.after_next, false)) ready_.push_back(std::exchange(each.bytes, {}));
  std::erase_if(delayed_, [](const Delayed& each) { return each.bytes.empty(); });
}

void FaultyWire::spoil(FriFaultKind kind, Datagram& bytes) {
  const std::size_t angle_at = carries_answers_ ? kCommandedAngleAt : kMeasuredAngleAt;
  switch (kind) {
    case FriFaultKind::kShort:
      bytes.resize(random_() % bytes.size());
      break;
    case FriFaultKind::kLong:
      bytes.resize(bytes.size() + 1 + random_() % 64);
      break;
    case FriFaultKind::kGarbled: {
      const std::size_t begin = random_() % bytes.size();
      const std::size_t end = std::min(bytes.size(), begin + kLeastGarbled + random_() % bytes.size());
      for (std::size_t i = begin; i < end; ++i) bytes[i] = static_cast<std::byte>(random_());
      break;
    }
    case FriFaultKind::kWrongId:
      if (bytes.size() > kIdAt) bytes[kIdAt] ^= std::byte{1};
      break;
    case FriFaultKind::kNotANumber:
      for (std::size_t i = angle_at; i < std::min(bytes.size(), angle_at + sizeof(float)); ++i)
        bytes[i] = kNotANumber;
      break;
    default:
      break;
  }
}

std::span<const Datagram> FaultyWire::take() {
  taken_.clear();
  std::swap(taken_, ready_);
  return taken_;
}

void FaultyWire::endCycle() {
  for (Delayed& each : delayed_)
    if (!each.after_next && --each.cycles <= 0) ready_.push_back(std::exchange(each.bytes, {}));
  std::erase_if(delayed_, [](const Delayed& each) { return each.bytes.empty(); });
}

}  // namespace mirrorarm::peers
