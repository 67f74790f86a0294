#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

#include "core/common/time.h"

namespace mirrorarm::control {

/// The three positions of an enabling device (IEC 60947-5-8), a pedal or a key that is held.
enum class EnablingPosition : std::uint8_t { kReleased, kEnabled, kPressedThrough };
/// "released", "enabled", "pressed_through".
[[nodiscard]] std::string_view id(EnablingPosition position);

/// The enabling device as the servo loop sees it. A device must say its position again and again: one that
/// has fallen silent, because its line broke or its window hangs, counts as released. From pressed through
/// the way to enabled leads over released.
class EnablingSwitch {
 public:
  /// Silence is borne so long.
  explicit EnablingSwitch(Seconds silent_after) : silent_after_(silent_after) {}

  /// Any thread; nothing waits.
  void set(EnablingPosition position) noexcept;

  /// Servo thread, once a cycle: what counts at `now`.
  [[nodiscard]] EnablingPosition update(TimePoint now) noexcept;

 private:
  const Seconds silent_after_;
  std::atomic<std::uint64_t> word_{0};  // the position in the low bits, the number of messages above

  // Servo thread only.
  std::uint64_t last_word_ = 0;
  TimePoint heard_at_{};
  EnablingPosition counted_ = EnablingPosition::kReleased;
};

}  // namespace mirrorarm::control
