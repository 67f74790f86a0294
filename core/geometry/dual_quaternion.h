#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm {

/// The pose that moves the points `x` onto the points `y` with the least sum of w * |y - (R x + t)|^2.
///
/// Dual quaternions: the rotation is the eigenvector of the largest eigenvalue of the 4x4 matrix
/// A = C3^T C2^-1 C3 / 4 - C1, found by power iteration (shifted so that the largest eigenvalue is also the
/// largest in magnitude). Needs equally long spans; 3 points that are not on a line and positive weights fix
/// the pose, fewer give one of many. Does not allocate.
/// Source: paper section 2.3.5, equations 26 to 36; Walker, Shao, Volz, CVGIP 54(3), 1991.
[[nodiscard]] RigidTransform fitByDualQuaternion(std::span<const Eigen::Vector3d> x,
                                                 std::span<const Eigen::Vector3d> y,
                                                 std::span<const double> weights);

/// The same for soft correspondences: `weights(j, k)` >= 0 couples x[j] with y[k] (the paper's m_jk).
[[nodiscard]] RigidTransform fitByDualQuaternion(std::span<const Eigen::Vector3d> x,
                                                 std::span<const Eigen::Vector3d> y,
                                                 const Eigen::Ref<const Eigen::MatrixXd>& weights);

}  // namespace mirrorarm
