#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tracking/cloud_point.h"
#include "core/tracking/shape.h"

namespace mirrorarm::tracking {

/// Drops matches that do not agree with the others: two matches agree when their points lie as far apart as
/// their markers, to `sigmas` of shape and sensor and to `slack_m` each. As long as any disagree the one that
/// disagrees with most others is dropped; what is left is a clique. Keeps its buffers.
class ConsistencyCheck {
 public:
  /// Sets what is dropped in `point_of_marker` to -1; returns how many are left.
  int run(const Shape& shape, std::span<const CloudPoint> cloud, double sigmas, double slack_m,
          std::vector<int>& point_of_marker);

 private:
  struct Match {
    std::size_t marker = 0;
    std::size_t point = 0;
    std::uint64_t against = 0;  ///< a bit for each match that it disagrees with
  };
  void compareAll(const Shape& shape, std::span<const CloudPoint> cloud, double sigmas, double slack_m);
  std::vector<Match> matches_;
};

}  // namespace mirrorarm::tracking
