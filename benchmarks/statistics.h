#pragma once

#include <cmath>

#include "core/common/quantile.h"

namespace mirrorarm::benchmarks {

/// Root of the mean square of what was added.
class RootMeanSquare {
 public:
  void addSquare(double square, int count = 1) {
    sum_ += square;
    count_ += count;
  }
  void join(const RootMeanSquare& other) { addSquare(other.sum_, other.count_); }
  [[nodiscard]] int count() const { return count_; }
  /// Not a number when nothing was added.
  [[nodiscard]] double value() const { return std::sqrt(sum_ / count_); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

struct Interval {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

/// Where the mean of `count` chi-square numbers of `freedom` degrees lies in 95 of 100 cases. Source: Wilson
/// and Hilferty, PNAS 17, 1931; exact to a thousandth for more than 30 degrees in all.
[[nodiscard]] Interval chiSquareMeanBand(int freedom, int count);

/// The mean number that makes `events` or fewer happen in only 5 of 100 cases: the upper 95 % limit of what
/// was counted.
[[nodiscard]] double poissonUpperLimit(int events);

}  // namespace mirrorarm::benchmarks
