#pragma once

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::tracking {

/// Tracking: from points to poses. docs/benchmarks.md says what each row means.
[[nodiscard]] Suite suite();

}  // namespace mirrorarm::benchmarks::tracking
