#include "core/geometry/rigid_fit.h"

#include <cassert>
#include <cmath>

#include <Eigen/SVD>

namespace mirrorarm {

Eigen::Vector3d centroid(std::span<const Eigen::Vector3d> points) {
  assert(!points.empty());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

RigidTransform fitByKabsch(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y) {
  assert(x.size() == y.size() && !x.empty());
  const Eigen::Vector3d mean_x = centroid(x), mean_y = centroid(y);
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
