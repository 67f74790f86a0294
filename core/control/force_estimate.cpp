#include "core/control/force_estimate.h"

#include <Eigen/Cholesky>

namespace mirrorarm::control {
namespace {

constexpr double kLength_m = 0.2;    // makes moments and forces comparable: about the length of a hand
constexpr double kDamping_m = 0.02;  // of the lever by which a direction is felt

}  // namespace

robot::Jacobian jacobianAt(const Eigen::Vector3d& p_FE_B, const robot::Jacobian& J_F) noexcept {
  robot::Jacobian J = J_F;
  for (Eigen::Index j = 0; j < J.cols(); ++j) {
    const Eigen::Vector3d turn = J_F.block<3, 1>(3, j);
    J.block<3, 1>(0, j) += turn.cross(p_FE_B);
  }
  return J;
}

Eigen::Matrix<double, 6, 1> wrenchOf(const robot::Joints& external_torque_nm,
                                     const robot::Jacobian& J) noexcept {
  robot::Jacobian scaled = J;
  scaled.bottomRows<3>() *= kLength_m;
  Eigen::Matrix<double, 6, 6> normal = scaled.lazyProduct(scaled.transpose());
  normal.diagonal().array() += kDamping_m * kDamping_m;
  const Eigen::Matrix<double, 6, 1> right = scaled.lazyProduct(external_torque_nm);
  Eigen::Matrix<double, 6, 1> wrench = normal.ldlt().solve(right);
  wrench.tail<3>() *= kLength_m;
  return wrench;
}

}  // namespace mirrorarm::control
