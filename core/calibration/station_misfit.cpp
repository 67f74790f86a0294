#include "core/calibration/station_misfit.h"

#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace mirrorarm::calibration {
namespace {

RigidTransform meanPose(std::span<const RigidTransform> poses, std::span<const double> weights) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix4d scatter = Eigen::Matrix4d::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    const Eigen::Vector4d q = rotationOf(poses[i]).coeffs();
    position += weight * poses[i].translation();
    scatter += weight * q * q.transpose();
    sum += weight;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(scatter);
  return makeTransform(Eigen::Quaterniond(Eigen::Vector4d(axes.eigenvectors().col(3))), position / sum);
}

double rms(std::span<const double> values, std::span<const double> weights) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    sum += weight * values[i] * values[i];
    count += weight;
  }
  return std::sqrt(sum / count);
}

}  // namespace

double StationMisfit::rms_m(std::span<const double> weights) const { return rms(position_m, weights); }
double StationMisfit::rms_rad(std::span<const double> weights) const { return rms(rotation_rad, weights); }

StationMisfit stationMisfit(std::span<const PosePair> pairs, const RigidTransform& X_FC,
                            std::span<const double> weights) {
  assert(!pairs.empty());
  std::vector<RigidTransform> seen;
  seen.reserve(pairs.size());
  for (const auto& pair : pairs) seen.push_back(pair.X_BF * X_FC * pair.X_CM);
  StationMisfit misfit;
  misfit.X_BM = meanPose(seen, weights);
  for (const auto& X_BM : seen) {
    misfit.position_m.push_back((X_BM.translation() - misfit.X_BM.translation()).norm());
    misfit.rotation_rad.push_back(angleBetween(X_BM, misfit.X_BM));
  }
  return misfit;
}

}  // namespace mirrorarm::calibration
