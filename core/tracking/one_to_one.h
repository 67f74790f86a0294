#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/tracking/cloud_point.h"

namespace mirrorarm::tracking {

/// A marker and a point that may be it.
struct CandidatePair {
  int marker = 0;
  int point = 0;
  double misfit = 0.0;  ///< the less, the likelier
};

/// Gives each marker its likeliest point, the likeliest pairs first, one-to-one also in discs; -1 for none.
/// `discsOf(point)` tells what a point was measured from. Sorts `pairs`; returns how many markers have a
/// point.
template <class DiscsOf>
int assignOneToOne(std::span<CandidatePair> pairs, DiscsOf discsOf, std::size_t markers,
                   std::vector<int>& point_of_marker) {
  std::sort(pairs.begin(), pairs.end(),
            [](const CandidatePair& a, const CandidatePair& b) { return a.misfit < b.misfit; });
  point_of_marker.assign(markers, -1);
  int matched = 0;
  for (const CandidatePair& pair : pairs) {
    int& point = point_of_marker[static_cast<std::size_t>(pair.marker)];
    if (point >= 0) continue;
    const bool taken = std::any_of(point_of_marker.begin(), point_of_marker.end(), [&](int other) {
      return other == pair.point || (other >= 0 && shareADisc(discsOf(other), discsOf(pair.point)));
    });
    if (taken) continue;
    point = pair.point;
    ++matched;
  }
  return matched;
}

}  // namespace mirrorarm::tracking
