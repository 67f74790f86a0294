#pragma once

#include <cassert>
#include <utility>
#include <vector>

#include "core/common/quantile.h"

namespace mirrorarm::calibration {

/// The middle value; of an even number the upper of the two. At least one value.
[[nodiscard]] inline double median(std::vector<double> values) {
  assert(!values.empty());
  return quantile(std::move(values), 0.5);
}

}  // namespace mirrorarm::calibration
