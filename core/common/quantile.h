#pragma once

#include <vector>

namespace mirrorarm {

/// The one of `values` below which a share 0..1 of them lies: 0 the least, 0.5 the median (of an even number
/// the upper of the middle two), 1 the greatest. Not a number when there are none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace mirrorarm
