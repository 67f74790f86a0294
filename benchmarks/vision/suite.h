#pragma once

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::vision {

/// Marker vision: from pixels to 3D points. docs/benchmarks.md says what each row means.
[[nodiscard]] Suite suite();

// The scenarios, a file each.
void measureRandomError(Run& run);
void measureRamp(Run& run);
void measureBias(Run& run);
void measureCutDiscs(Run& run);
void measureRecall(Run& run);
void measurePointCovariance(Run& run);
void measureFrameTime(Run& run);
void measureDiscTime(Run& run);

}  // namespace mirrorarm::benchmarks::vision
