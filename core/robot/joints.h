#pragma once

#include <Eigen/Core>

namespace mirrorarm::robot {

inline constexpr int kMaxJoints = 8;

/// One number a joint, base to flange [rad, rad/s, rad/s^2]. Never on the heap.
using Joints = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;

/// d(flange twist)/dq in base frame B: linear rows [m/rad] above angular rows [rad/rad].
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;

}  // namespace mirrorarm::robot
