#include "core/tracking/functional_axes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr int kMeanRounds = 10;
constexpr double kLeastInformation = 1e-4;  // share of the best known direction, squared turns

/// The orientation from which all turns sum to zero (Karcher's mean).
Matrix3d meanRotation(std::span<const RigidTransform> X_PC) {
  Matrix3d mean = X_PC.front().linear();
  for (int round = 0; round < kMeanRounds; ++round) {
    Vector3d sum = Vector3d::Zero();
    for (const auto& X : X_PC) sum += rotationVector(X.linear() * mean.transpose());
    const Vector3d step = sum / static_cast<double>(X_PC.size());
    if (step.norm() < 1e-12) break;
    mean = Eigen::AngleAxisd(step.norm(), step.normalized()).toRotationMatrix() * mean;
  }
  return mean;
}

}  // namespace

RotationSpread rotationSpread(std::span<const RigidTransform> X_PC) {
  assert(X_PC.size() >= 2);
  RotationSpread spread;
  spread.mean_R_PC = meanRotation(X_PC);
  Matrix3d scatter = Matrix3d::Zero();
  for (const auto& X : X_PC) {
    const Vector3d turn = rotationVector(X.linear() * spread.mean_R_PC.transpose());
    scatter += turn * turn.transpose() / static_cast<double>(X_PC.size());
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(scatter);
  spread.axis_P = axes.eigenvectors().col(2);
  spread.across_rms_rad = std::sqrt(std::max(0.0, axes.eigenvalues()[1]));
  double low = 0.0, high = 0.0;
  for (const auto& X : X_PC) {
    const double turn = spread.axis_P.dot(rotationVector(X.linear() * spread.mean_R_PC.transpose()));
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  spread.range_rad = high - low;
  return spread;
}

std::optional<RotationCentre> rotationCentre(std::span<const RigidTransform> X_PC,
                                             const std::optional<Vector3d>& hinge_P) {
  assert(!X_PC.empty());
  const double share = 1.0 / static_cast<double>(X_PC.size());
  Matrix6d normal = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  Vector3d origin_P = Vector3d::Zero();
  for (const auto& X : X_PC) {
    Eigen::Matrix<double, 3, 6> A;
    A << X.linear(), -Matrix3d::Identity();
    normal += share * A.transpose() * A;
    right -= share * A.transpose() * X.translation();
    origin_P += share * X.translation();
  }
  if (hinge_P) {
    Vector6d along = Vector6d::Zero();
    along.tail<3>() = *hinge_P;
    normal += along * along.transpose();
    right += along * hinge_P->dot(origin_P);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(normal);
  if (!(eigen.eigenvalues()[0] > kLeastInformation * eigen.eigenvalues()[5])) return std::nullopt;
  const Vector6d both = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().cwiseProduct(
                                                   eigen.eigenvectors().transpose() * right);
  RotationCentre centre{both.tail<3>(), both.head<3>(), 0.0};
  double sum = 0.0;
  for (const auto& X : X_PC) sum += (X * centre.in_C - centre.in_P).squaredNorm();
  centre.rms_m = std::sqrt(share * sum);
  return centre;
}

}  // namespace mirrorarm::tracking
