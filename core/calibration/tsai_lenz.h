#pragma once

#include <optional>
#include <span>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// The solvers of X_BF * X_FC * X_CM = X_BM with X_BM the same at all stations; both give X_FC. A camera that
/// stands still is the same problem with X_FB in place of X_BF, the answer is then X_BC.

/// Tsai-Lenz as the ViSP library builds it: closed form over pairs of stations, then a least-squares
/// refinement. The paper's (section 2.1). Nothing where ViSP gives up. ViSP prints to std::cout, which is
/// silenced meanwhile: other threads must not print there.
[[nodiscard]] std::optional<RigidTransform> tsaiLenzByVisp(std::span<const PosePair> pairs);

/// Tsai-Lenz by least squares over all pairs of stations that tell something, see tellingMotions. `weights`:
/// one a station, >= 0; empty for equal ones. Nothing when the turns do not fix the answer. Source: Tsai,
/// Lenz, IEEE Trans. Robotics and Automation 5(3), 1989.
[[nodiscard]] std::optional<RigidTransform> tsaiLenzOverAllPairs(std::span<const PosePair> pairs,
                                                                 std::span<const double> weights = {});

}  // namespace mirrorarm::calibration
