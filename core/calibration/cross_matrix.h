#pragma once

#include <Eigen/Core>

namespace mirrorarm::calibration {

/// The matrix that multiplies as v does in a cross product: crossMatrix(v) * w = v x w.
[[nodiscard]] inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d V;
  V << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return V;
}

}  // namespace mirrorarm::calibration
