#include "core/geometry/rigid_fit.h"

#include <cassert>
#include <cmath>

#include <Eigen/SVD>

namespace mirrorarm {

RigidTransform fitByKabsch(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y) {
  assert(x.size() == y.size() && !x.empty());
  Eigen::Vector3d mean_x = Eigen::Vector3d::Zero(), mean_y = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i];
    mean_y += y[i];
  }
  mean_x /= static_cast<double>(x.size());
  mean_y /= static_cast<double>(y.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) covariance += (y[i] - mean_y) * (x[i] - mean_x).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d keep_handed = Eigen::Matrix3d::Identity();
  keep_handed(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d R = svd.matrixU() * keep_handed * svd.matrixV().transpose();
  return makeTransform(R, mean_y - R * mean_x);
}

double fitRms(const RigidTransform& X, std::span<const Eigen::Vector3d> x,
              std::span<const Eigen::Vector3d> y) {
  assert(x.size() == y.size() && !x.empty());
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (y[i] - X * x[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(x.size()));
}

}  // namespace mirrorarm
