#include "core/tracking/gated_pairs.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d crossMatrix(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Of a marker's place, in T, from the pose's own.
Matrix3d covarianceAt(const Vector3d& p_T, const Eigen::Matrix<double, 6, 6>& pose) {
  Eigen::Matrix<double, 3, 6> J;
  J << -crossMatrix(p_T), Matrix3d::Identity();
  return J * pose * J.transpose();
}

/// Of where a marker is expected, in T.
Matrix3d covarianceOf(const Shape& shape, std::size_t marker, const UncertainPose& expected, double slack_m) {
  return covarianceAt(shape.markers_T[marker], expected.covariance) + shape.covarianceOf(marker) +
         slack_m * slack_m * Matrix3d::Identity();
}

/// One of a marker's point and disc is another's already.
bool clashes(std::span<const CloudPoint> cloud, std::span<const int> point_of_marker, int point) {
  const SeenDiscs& discs = cloud[static_cast<std::size_t>(point)].discs;
  return std::any_of(point_of_marker.begin(), point_of_marker.end(), [&](int other) {
    return other >= 0 && shareADisc(cloud[static_cast<std::size_t>(other)].discs, discs);
  });
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
  const Matrix3d R_CT = expected.X_CT.linear();
  for (std::size_t j = 0; j < shape.size(); ++j) {
    if (!shape.counts(j)) continue;
    const Matrix3d covariance_C = R_CT * covarianceOf(shape, j, expected, slack_m) * R_CT.transpose();
    addPairsOf(static_cast<int>(j), expected.X_CT * shape.markers_T[j], covariance_C, cloud, gate_sigmas);
  }
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
  std::sort(pairs_.begin(), pairs_.end(),
            [](const GatedPair& a, const GatedPair& b) { return a.misfit < b.misfit; });
  point_of_marker.assign(markers_, -1);
  taken_.assign(cloud.size(), 0);
  for (const GatedPair& pair : pairs_) {
    int& point = point_of_marker[static_cast<std::size_t>(pair.marker)];
    char& taken = taken_[static_cast<std::size_t>(pair.point)];
    if (point >= 0 || taken != 0 || clashes(cloud, point_of_marker, pair.point)) continue;
    point = pair.point;
    taken = 1;
  }
}

}  // namespace mirrorarm::tracking
