#include "core/calibration/station_misfit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "core/calibration/median.h"
#include "core/calibration/tsai_lenz.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kRounds = 20;
constexpr double kSoftLimit = 2.0;  ///< medians at which a station's weight falls to a quarter
constexpr double kHardLimit = 4.0;  ///< medians beyond which a station is named; 6 sigma of normal noise
/// Below these no station is worth naming: a robot's repeatability.
constexpr double kLeastMedian_m = 5e-5;
constexpr double kLeastMedian_rad = 1e-4;

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

double rms(std::span<const double> values) {
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Each station's misfit in units of the median one, the worse of position and rotation.
std::vector<double> inMedians(std::span<const double> position_m, std::span<const double> rotation_rad) {
  const double unit_m = std::max(median({position_m.begin(), position_m.end()}), kLeastMedian_m);
  const double unit_rad = std::max(median({rotation_rad.begin(), rotation_rad.end()}), kLeastMedian_rad);
  std::vector<double> scaled(position_m.size());
  for (std::size_t i = 0; i < scaled.size(); ++i)
    scaled[i] = std::max(position_m[i] / unit_m, rotation_rad[i] / unit_rad);
  return scaled;
}

/// Distance moved along the axis of the turn.
double pitch_m(const RigidTransform& X) {
  return X.translation().dot(rotationVector(X.linear()).stableNormalized());
}

/// Robot and camera make the same screw between two stations, wherever the camera sits: equal turn and equal
/// pitch. Each station's median mismatch with the others, in units of the median one; needs no assumed X_FC.
/// Source: Chen, IEEE CVPR 1991, "A screw motion approach to uniqueness analysis of head-eye geometry".
std::vector<double> screwMismatch(std::span<const PosePair> pairs) {
  std::vector<std::vector<double>> pitches_m(pairs.size()), turns_rad(pairs.size());
  for (const auto& [i, j, A, B] : relativeMotions(pairs)) {
    const double pitch = std::abs(pitch_m(A) - pitch_m(B));
    const double turn = std::abs(rotationVector(A.linear()).norm() - rotationVector(B.linear()).norm());
    for (const auto station : {i, j}) {
      pitches_m[station].push_back(pitch);
      turns_rad[station].push_back(turn);
    }
  }
  std::vector<double> position_m, rotation_rad;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    position_m.push_back(median(pitches_m[i]));
    rotation_rad.push_back(median(turns_rad[i]));
  }
  return inMedians(position_m, rotation_rad);
}

std::vector<double> softWeights(std::span<const double> scaled) {
  std::vector<double> weights(scaled.size());
  std::transform(scaled.begin(), scaled.end(), weights.begin(), [](double misfit) {
    const double share = 1.0 / (1.0 + std::pow(misfit / kSoftLimit, 2));
    return share * share;
  });
  return weights;
}

}  // namespace

double StationMisfit::rms_m() const { return rms(position_m); }
double StationMisfit::rms_rad() const { return rms(rotation_rad); }

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

std::vector<std::size_t> contradictingStations(std::span<const PosePair> pairs) {
  if (pairs.size() < 2) return {};
  auto scaled = screwMismatch(pairs);
  for (int round = 0; round < kRounds; ++round) {
    const auto weights = softWeights(scaled);
    const auto X_FC = tsaiLenzOverAllPairs(pairs, weights);
    if (!X_FC) return {};
    const auto misfit = stationMisfit(pairs, *X_FC, weights);
    scaled = inMedians(misfit.position_m, misfit.rotation_rad);
  }
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < scaled.size(); ++i)
    if (scaled[i] > kHardLimit) named.push_back(i);
  return named;
}

}  // namespace mirrorarm::calibration
