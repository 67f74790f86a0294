#pragma once

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/robot/joints.h"

namespace mirrorarm::control {

/// The flange's Jacobian moved to a point that is fixed to the flange: `p_FE_B` is the way from the flange to
/// the point in base axes [m].
[[nodiscard]] robot::Jacobian jacobianAt(const Eigen::Vector3d& p_FE_B, const robot::Jacobian& J_F) noexcept;

/// The force [N], then the moment [Nm], that acts on the arm from outside at the point of `J`, in base axes,
/// given the torques that it causes in the joints: the damped least-squares inverse of torque = J^T wrench.
/// Where the posture hides a direction the answer fades in it instead of growing without bound. Does not
/// allocate.
[[nodiscard]] Eigen::Matrix<double, 6, 1> wrenchOf(const robot::Joints& external_torque_nm,
                                                   const robot::Jacobian& J) noexcept;

}  // namespace mirrorarm::control
