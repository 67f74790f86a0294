#include "benchmarks/statistics.h"

#include <algorithm>

namespace mirrorarm::benchmarks {
namespace {

double poissonAtMost(int events, double mean) {
  double sum = 0.0;
  for (int k = 0; k <= events; ++k) sum += std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
  return sum;
}

}  // namespace

Interval chiSquareMeanBand(int freedom, int count) {
  const double degrees = static_cast<double>(freedom) * count;
  const auto at = [&](double normal) {
    const double spread = 2.0 / (9.0 * degrees);
    return freedom * std::pow(1.0 - spread + normal * std::sqrt(spread), 3.0);
  };
  return {at(-1.959964), at(1.959964)};
}

double poissonUpperLimit(int events) {
  double low = std::max(events, 1) * 0.5, high = 3.0 * events + 10.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (poissonAtMost(events, middle) > 0.05 ? low : high) = middle;
  }
  return high;
}

}  // namespace mirrorarm::benchmarks
