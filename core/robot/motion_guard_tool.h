#pragma once

#include "core/robot/joints.h"
#include "core/robot/motion_guard_stop.h"

namespace mirrorarm::robot {

/// Linear part of the flange's twist at joint speeds `v` [m/s].
[[nodiscard]] inline Eigen::Vector3d toolOf(const Jacobian& jacobian, const Joints& v) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index j = 0; j < v.size(); ++j) sum += jacobian.block<3, 1>(0, j) * v[j];
  return sum;
}

/// Second derivative of the flange's position along joint speeds `u` and `v` [m/s^2], from the Jacobian
/// alone: how the flange accelerates while the joints keep their speed, when both are that speed.
[[nodiscard]] Eigen::Vector3d curvature(const Jacobian& jacobian, const Joints& u, const Joints& v);

/// The flange's path to the second order, along joint motions that are sums of one speed and one
/// acceleration.
class ToolMotion {
 public:
  /// At joint speeds `v` and accelerations `a`, `ahead_s` after the joints were where `jacobian` is.
  ToolMotion(const Jacobian& jacobian, const Joints& v, const Joints& a, double ahead_s);

  [[nodiscard]] Eigen::Vector3d speed(const Moment& moment) const;
  [[nodiscard]] Eigen::Vector3d acceleration(const Moment& moment) const;

 private:
  /// Curvature along two sums.
  [[nodiscard]] Eigen::Vector3d curved(const Share& one, const Share& other) const;

  Eigen::Vector3d vv_, va_, aa_, v_, a_;
};

}  // namespace mirrorarm::robot
