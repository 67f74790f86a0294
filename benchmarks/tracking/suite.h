#pragma once

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::tracking {

/// Tracking: from points to poses. docs/benchmarks.md says what each row means.
[[nodiscard]] Suite suite();

void measureRegistration(Run& run);
void measureBodies(Run& run);
void measureFalsePoses(Run& run);
void measurePose(Run& run);
void measurePrediction(Run& run);
void measureSkin(Run& run);
void measureChain(Run& run);
void measureTeaching(Run& run);

}  // namespace mirrorarm::benchmarks::tracking
