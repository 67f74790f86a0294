#pragma once

#include "core/robot/srs_limits.h"

namespace mirrorarm::robot {

/// How the discomfort of a posture changes as the elbow turns: d(discomfort)/d(arm angle). Discomfort grows
/// without bound towards the ends of the joints' ranges, and towards an aligned shoulder or wrist from 20
/// degrees on.
[[nodiscard]] double discomfortSlope(const SrsPostures& postures, const JointRanges& ranges, const Joints& q);

/// The arm angle, at most `reach` from `arm_angle` and on the same branch, to which discomfort falls from
/// there.
[[nodiscard]] double comfortableArmAngle(const SrsPostures& postures, const JointRanges& ranges, int branch,
                                         double arm_angle, double reach);

}  // namespace mirrorarm::robot
