#include "core/tracking/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace mirrorarm::tracking {

bool areCollinear(std::span<const Eigen::Vector3d> points) {
  if (points.size() < 3) return true;
  const auto count = static_cast<double>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& p : points) scatter += (p - mean) * (p - mean).transpose() / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter, Eigen::EigenvaluesOnly);
  const double beside_line = solver.eigenvalues()[0] + solver.eigenvalues()[1];
  return !(std::sqrt(std::max(0.0, beside_line)) > kLineWidth_m);
}

double smallestDistance(std::span<const Eigen::Vector3d> points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, (points[i] - points[j]).norm());
  return smallest;
}

}  // namespace mirrorarm::tracking
