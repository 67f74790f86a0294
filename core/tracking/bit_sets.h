#pragma once

#include <bit>
#include <cstdint>

#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {

/// A set of markers of one target: bit j is marker j.
using MarkerSet = std::uint64_t;
static_assert(kMaxMarkers == 64);

[[nodiscard]] constexpr MarkerSet markerBit(int marker) { return MarkerSet{1} << marker; }

/// How many bits are set. Counted here: std::popcount is a call where the processor's own count may not be
/// relied upon.
[[nodiscard]] constexpr int countBits(std::uint64_t bits) {
  bits -= (bits >> 1) & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + ((bits >> 2) & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>((bits * 0x0101010101010101) >> 56);
}

/// A set of points of one cloud.
struct PointSet {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  [[nodiscard]] static constexpr PointSet of(int point) {
    return point < 64 ? PointSet{std::uint64_t{1} << point, 0}
                      : PointSet{0, std::uint64_t{1} << (point - 64)};
  }
  [[nodiscard]] constexpr bool isEmpty() const { return (low | high) == 0; }
  [[nodiscard]] constexpr bool holds(int point) const { return !(*this & of(point)).isEmpty(); }
  [[nodiscard]] constexpr int count() const { return countBits(low) + countBits(high); }

  constexpr PointSet& operator|=(const PointSet& other) {
    low |= other.low;
    high |= other.high;
    return *this;
  }
  [[nodiscard]] friend constexpr PointSet operator&(const PointSet& a, const PointSet& b) {
    return {a.low & b.low, a.high & b.high};
  }
  [[nodiscard]] constexpr PointSet without(const PointSet& other) const {
    return {low & ~other.low, high & ~other.high};
  }
  /// Takes the first point out of a set that is not empty.
  constexpr int takeFirst() {
    std::uint64_t& part = low != 0 ? low : high;
    const int point = std::countr_zero(part) + (low != 0 ? 0 : 64);
    part &= part - 1;
    return point;
  }
};
static_assert(kMaxPoints == 128);

}  // namespace mirrorarm::tracking
