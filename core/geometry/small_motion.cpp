#include "core/geometry/small_motion.h"

namespace mirrorarm {

Eigen::Matrix3d turnBy(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

RigidTransform smallMotion(const SmallMotion& motion) {
  return makeTransform(turnBy(motion.head<3>()), motion.tail<3>());
}

RigidTransform moved(const RigidTransform& X_CT, const SmallMotion& motion) {
  RigidTransform result = X_CT * smallMotion(motion);
  result.linear() = rotationOf(result).toRotationMatrix();
  return result;
}

}  // namespace mirrorarm
