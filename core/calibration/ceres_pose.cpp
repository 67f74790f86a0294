#include "core/calibration/ceres_pose.h"

#include <ceres/ceres.h>
#include <utility>
#include <vector>

namespace mirrorarm::calibration {

void addPose(ceres::Problem& problem, PoseBlock& block) {
  problem.AddParameterBlock(
      block.data(), 7,
      new ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>);
}

std::optional<Eigen::Matrix<double, 6, 6>> smallMotionCovariance(ceres::Problem& problem,
                                                                 const PoseBlock& block) {
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::DENSE_SVD;
  ceres::Covariance covariance(options);
  const std::vector<std::pair<const double*, const double*>> wanted = {{block.data(), block.data()}};
  if (!covariance.Compute(wanted, &problem)) return std::nullopt;
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> outer;
  if (!covariance.GetCovarianceBlockInTangentSpace(block.data(), block.data(), outer.data()))
    return std::nullopt;
  const Eigen::Matrix3d R_inner_outer = poseOf(block).linear().transpose();
  Eigen::Matrix<double, 6, 6> J = Eigen::Matrix<double, 6, 6>::Zero();
  J.topLeftCorner<3, 3>() = 2.0 * R_inner_outer;
  J.bottomRightCorner<3, 3>() = R_inner_outer;
  return J * outer * J.transpose();
}

}  // namespace mirrorarm::calibration
