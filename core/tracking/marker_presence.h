#pragma once

#include <span>
#include <vector>

#include "core/common/time.h"

namespace mirrorarm::tracking {

/// Tells which markers are still on the body: one that both cameras could see and that was not found for
/// `missing_time` has fallen off, one that is found again for a moment is back.
class MarkerPresence {
 public:
  explicit MarkerPresence(Seconds missing_time) : missing_time_(missing_time) {}

  void resize(std::size_t markers);
  /// One frame of an accepted pose; true when a marker has fallen off in it.
  [[nodiscard]] bool loses(std::span<const char> seen, std::span<const char> in_view, Seconds step);
  /// True when one has come back in it.
  [[nodiscard]] bool finds(std::span<const char> seen);

  [[nodiscard]] std::span<const char> present() const { return present_; }
  /// For how long a marker has been in view and not found.
  [[nodiscard]] Seconds missing(std::size_t marker) const { return missing_[marker]; }

 private:
  Seconds missing_time_;
  std::vector<char> present_;
  std::vector<Seconds> missing_;
  std::vector<int> frames_back_;
};

}  // namespace mirrorarm::tracking
