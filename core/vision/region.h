#pragma once

#include <algorithm>

namespace mirrorarm::vision {

/// A rectangle of raw pixels, both ends included; empty when an end lies before its beginning.
struct Region {
  int left = 0, top = 0, right = -1, bottom = -1;

  [[nodiscard]] int width() const { return right - left + 1; }
  [[nodiscard]] int height() const { return bottom - top + 1; }
  [[nodiscard]] bool empty() const { return right < left || bottom < top; }
};

[[nodiscard]] inline Region intersection(const Region& a, const Region& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

/// The smallest rectangle that holds both.
[[nodiscard]] inline Region hull(const Region& a, const Region& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

[[nodiscard]] inline Region grown(const Region& region, int by_px) {
  return {region.left - by_px, region.top - by_px, region.right + by_px, region.bottom + by_px};
}

}  // namespace mirrorarm::vision
