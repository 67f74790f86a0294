#include "core/tracking/gated_pairs.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Of where a marker is expected, in T.
Matrix3d covarianceOf(const Shape& shape, std::size_t marker, const UncertainPose& expected, double slack_m) {
  const Eigen::Matrix<double, 3, 6> J = motionAt(shape.markers_T[marker]);
  return J * expected.covariance * J.transpose() + shape.covarianceOf(marker) +
         slack_m * slack_m * Matrix3d::Identity();
}

}  // namespace

double gateRadius(const Shape& shape, const UncertainPose& expected, double gate_sigmas, double slack_m) {
  double variance_m2 = 0.0;
  for (std::size_t j = 0; j < shape.size(); ++j)
    if (shape.counts(j))
      variance_m2 = std::max(variance_m2, covarianceOf(shape, j, expected, slack_m).trace());
  return gate_sigmas * std::sqrt(variance_m2);
}

void GatedPairs::find(const Shape& shape, std::span<const CloudPoint> cloud, const UncertainPose& expected,
                      double gate_sigmas, double slack_m) {
  pairs_.clear();
  markers_ = shape.size();
  double widest_m2 = 0.0;
  const Matrix3d R_CT = expected.X_CT.linear();
  for (std::size_t j = 0; j < shape.size(); ++j) {
    if (!shape.counts(j)) continue;
    const Matrix3d covariance_T = covarianceOf(shape, j, expected, slack_m);
    const Matrix3d covariance_C = R_CT * covariance_T * R_CT.transpose();
    widest_m2 = std::max(widest_m2, covariance_T.trace());
    addPairsOf(static_cast<int>(j), expected.X_CT * shape.markers_T[j], covariance_C, cloud, gate_sigmas);
  }
  radius_m_ = gate_sigmas * std::sqrt(widest_m2);
}

void GatedPairs::addPairsOf(int marker, const Vector3d& expected_C, const Matrix3d& covariance_C_m2,
                            std::span<const CloudPoint> cloud, double gate_sigmas) {
  const double gate = gate_sigmas * gate_sigmas;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    const Vector3d off = cloud[k].p_C - expected_C;
    const Matrix3d covariance = covariance_C_m2 + cloud[k].covariance_m2;
    // The trace bounds the largest variance: most points are far outside it.
    if (off.squaredNorm() > gate * covariance.trace()) continue;
    const double misfit = off.dot(covariance.inverse() * off);
    if (misfit <= gate) pairs_.push_back({marker, static_cast<int>(k), misfit});
  }
}

bool GatedPairs::areUnique(std::span<const CloudPoint> cloud) const {
  for (auto a = pairs_.begin(); a != pairs_.end(); ++a)
    for (auto b = a + 1; b != pairs_.end(); ++b)
      if (a->marker == b->marker || a->point == b->point ||
          shareADisc(cloud[static_cast<std::size_t>(a->point)].discs,
                     cloud[static_cast<std::size_t>(b->point)].discs))
        return false;
  return true;
}

void GatedPairs::assign(std::span<const CloudPoint> cloud, std::vector<int>& point_of_marker) {
  const auto discsOf = [cloud](int point) { return cloud[static_cast<std::size_t>(point)].discs; };
  assignOneToOne(pairs_, discsOf, markers_, point_of_marker);
}

}  // namespace mirrorarm::tracking
