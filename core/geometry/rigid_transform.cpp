#include "core/geometry/rigid_transform.h"

#include <cassert>

namespace mirrorarm {

RigidTransform makeTransform(const Eigen::Matrix3d& R_AB, const Eigen::Vector3d& p_AB) {
  RigidTransform X = RigidTransform::Identity();
  X.linear() = R_AB;
  X.translation() = p_AB;
  return X;
}

RigidTransform makeTransform(const Eigen::Quaterniond& q_AB, const Eigen::Vector3d& p_AB) {
  assert(q_AB.norm() > 0.0);
  return makeTransform(q_AB.normalized().toRotationMatrix(), p_AB);
}

Eigen::Quaterniond rotationOf(const RigidTransform& X_AB) {
  Eigen::Quaterniond q(X_AB.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

double angleBetween(const RigidTransform& X_AB, const RigidTransform& X_AC) {
  return rotationOf(X_AB).angularDistance(rotationOf(X_AC));
}

RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to, double share) {
  return makeTransform(rotationOf(from).slerp(share, rotationOf(to)),
                       (1.0 - share) * from.translation() + share * to.translation());
}

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

bool isRigid(const RigidTransform& X, double tolerance) {
  return X.matrix().allFinite() &&
         (X.linear() * X.linear().transpose() - Eigen::Matrix3d::Identity()).norm() < tolerance &&
         X.linear().determinant() > 0.0;
}

}  // namespace mirrorarm
