#include "core/robot/motion_guard_tool.h"

#include <Eigen/Geometry>

namespace mirrorarm::robot {

Eigen::Vector3d curvature(const Jacobian& jacobian, const Joints& u, const Joints& v) {
  // d J_k / d q_j = z_j x J_k for a joint j before k or k itself, z_k x J_j for one after it.
  Eigen::Vector3d after = toolOf(jacobian, u), turning = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < v.size(); ++k) {
    const Eigen::Vector3d J = jacobian.block<3, 1>(0, k), z = jacobian.block<3, 1>(3, k);
    turning += u[k] * z;
    after -= u[k] * J;
    sum += v[k] * (turning.cross(J) + z.cross(after));
  }
  return sum;
}

ToolMotion::ToolMotion(const Jacobian& jacobian, const Joints& v, const Joints& a, double ahead_s)
    : vv_(curvature(jacobian, v, v)),
      va_(curvature(jacobian, v, a)),
      aa_(curvature(jacobian, a, a)),
      v_(toolOf(jacobian, v) + ahead_s * vv_),
      a_(toolOf(jacobian, a) + ahead_s * va_) {}

Eigen::Vector3d ToolMotion::speed(const Moment& moment) const {
  return moment.speed[0] * v_ + moment.speed[1] * a_ + curved(moment.displacement, moment.speed);
}

Eigen::Vector3d ToolMotion::acceleration(const Moment& moment) const {
  return moment.acceleration[0] * v_ + moment.acceleration[1] * a_ +
         curved(moment.displacement, moment.acceleration) + curved(moment.speed, moment.speed);
}

Eigen::Vector3d ToolMotion::curved(const Share& one, const Share& other) const {
  return one[0] * other[0] * vv_ + (one[0] * other[1] + one[1] * other[0]) * va_ + one[1] * other[1] * aa_;
}

}  // namespace mirrorarm::robot
