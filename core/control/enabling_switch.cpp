#include "core/control/enabling_switch.h"

namespace mirrorarm::control {
namespace {

constexpr unsigned kPositionBits = 8;

EnablingPosition positionIn(std::uint64_t word) {
  return static_cast<EnablingPosition>(word & ((1U << kPositionBits) - 1U));
}

}  // namespace

std::string_view id(EnablingPosition position) {
  switch (position) {
    case EnablingPosition::kReleased:
      return "released";
    case EnablingPosition::kEnabled:
      return "enabled";
    case EnablingPosition::kPressedThrough:
      return "pressed_through";
  }
  return "unknown";
}

void EnablingSwitch::set(EnablingPosition position) noexcept {
  std::uint64_t word = word_.load(std::memory_order_relaxed);
  std::uint64_t next = 0;
  do {
    next = (((word >> kPositionBits) + 1) << kPositionBits) | static_cast<std::uint64_t>(position);
  } while (!word_.compare_exchange_weak(word, next, std::memory_order_acq_rel));
}

EnablingPosition EnablingSwitch::update(TimePoint now) noexcept {
  const std::uint64_t word = word_.load(std::memory_order_acquire);
  if (word != last_word_) heard_at_ = now;
  last_word_ = word;
  const bool silent = secondsBetween(heard_at_, now) > silent_after_.count();
  const EnablingPosition said = silent ? EnablingPosition::kReleased : positionIn(word);
  const bool still_in_a_fright =
      counted_ == EnablingPosition::kPressedThrough && said == EnablingPosition::kEnabled;
  if (!still_in_a_fright) counted_ = said;
  return counted_;
}

}  // namespace mirrorarm::control
