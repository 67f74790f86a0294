#include "core/tracking/marker_presence.h"

#include <algorithm>

namespace mirrorarm::tracking {
namespace {

constexpr int kFramesToBeBack = 3;
constexpr int kLeastPresent = 4;  // a target of fewer fixes no pose that could tell who is missing

}  // namespace

void MarkerPresence::resize(std::size_t markers) {
  present_.resize(markers, 1);
  missing_.resize(markers, Seconds{0.0});
  frames_back_.resize(markers, 0);
}

bool MarkerPresence::loses(std::span<const char> seen, std::span<const char> in_view, Seconds step) {
  bool lost = false;
  for (std::size_t i = 0; i < present_.size(); ++i) {
    if (seen[i] != 0)
      missing_[i] = Seconds{0.0};
    else if (in_view.empty() || in_view[i] != 0)
      missing_[i] += step;
    if (present_[i] == 0 || missing_[i] < missing_time_) continue;
    if (std::count(present_.begin(), present_.end(), 1) <= kLeastPresent) continue;
    present_[i] = 0;
    lost = true;
  }
  return lost;
}

bool MarkerPresence::finds(std::span<const char> seen) {
  bool found = false;
  for (std::size_t i = 0; i < present_.size(); ++i) {
    frames_back_[i] = seen[i] != 0 && present_[i] == 0 ? frames_back_[i] + 1 : 0;
    if (frames_back_[i] < kFramesToBeBack) continue;
    present_[i] = 1;
    frames_back_[i] = 0;
    found = true;
  }
  return found;
}

}  // namespace mirrorarm::tracking
