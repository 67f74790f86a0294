#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// The distances between the markers of many targets, to be looked up by length: a sorted list with a table
/// of where each short stretch of lengths begins.
class DistanceIndex {
 public:
  /// How far markers `a` < `b` of a target lie apart.
  struct Entry {
    float distance_m = 0.0F;
    std::uint16_t target = 0;
    std::uint8_t a = 0;
    std::uint8_t b = 0;
  };

  /// At most 65536 targets of at most kMaxMarkers.
  void build(std::span<const std::vector<Eigen::Vector3d>> targets_T);

  /// Longest distance of all; 0 when there is none [m].
  [[nodiscard]] double longest() const { return entries_.empty() ? 0.0 : entries_.back().distance_m; }
  /// Calls `visit(entry)` for every distance that differs from `distance_m` by at most `width_m`.
  template <class Visit>
  void forEachNear(double distance_m, double width_m, Visit visit) const {
    const auto low = static_cast<float>(distance_m - width_m),
               high = static_cast<float>(distance_m + width_m);
    if (entries_.empty() || low > entries_.back().distance_m) return;
    for (std::size_t i = firstOf(low); i < entries_.size() && entries_[i].distance_m <= high; ++i)
      if (entries_[i].distance_m >= low) visit(entries_[i]);
  }

 private:
  [[nodiscard]] std::size_t firstOf(float distance_m) const {
    return first_[static_cast<std::size_t>(std::max(0.0F, distance_m * stretches_per_m_))];
  }

  std::vector<Entry> entries_;      ///< shortest first
  std::vector<std::size_t> first_;  ///< of each stretch the first entry not shorter than its beginning
  float stretches_per_m_ = 0.0F;
};

}  // namespace mirrorarm::tracking
