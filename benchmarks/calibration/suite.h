#pragma once

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::calibration {

/// Calibration: from images and robot poses to a rig, a camera on a flange and a clock. docs/benchmarks.md
/// says what each row means.
[[nodiscard]] Suite suite();

void measurePhotographs(Run& run);
void measureSimulatedRig(Run& run);
void measureWholeChain(Run& run);
void measureHandEye(Run& run);
void measureRefusals(Run& run);
void measureClock(Run& run);

}  // namespace mirrorarm::benchmarks::calibration
