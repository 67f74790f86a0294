#pragma once

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::robot {

/// The robot that follows: kinematics, planning, motion, guard, links. docs/benchmarks.md says what each row
/// means.
[[nodiscard]] Suite suite();

void measureFri(Run& run);
void measureGuard(Run& run);
void measureInverseKinematics(Run& run);
void measureLatency(Run& run);
void measureMotion(Run& run);
void measurePlanning(Run& run);
void measureStop(Run& run);

}  // namespace mirrorarm::benchmarks::robot
