#pragma once

#include <vector>

#include "benchmarks/trial_random.h"

namespace mirrorarm::benchmarks::vision {

/// A million standard normal numbers, taken row by row at random offsets: noise for large images at the cost
/// of copying. Use by several threads.
class NoiseTable {
 public:
  NoiseTable();

  /// `count` numbers, at most a tenth of the table.
  [[nodiscard]] const float* row(int count, TrialRandom& random) const {
    return normal_.data() + random.index(static_cast<int>(normal_.size()) - count);
  }

 private:
  std::vector<float> normal_;
};

}  // namespace mirrorarm::benchmarks::vision
