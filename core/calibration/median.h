#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

namespace mirrorarm::calibration {

/// The middle value; of an even number the upper of the two. At least one value.
[[nodiscard]] inline double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace mirrorarm::calibration
