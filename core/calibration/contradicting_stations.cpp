#include "core/calibration/contradicting_stations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/calibration/median.h"
#include "core/calibration/relative_motion.h"
#include "core/calibration/station_misfit.h"
#include "core/calibration/tsai_lenz.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kRounds = 20;
constexpr std::size_t kFewestToName = 5;  ///< of fewer the others do not fix each other
constexpr double kSoftLimit = 2.0;        ///< medians at which a station's weight falls to a quarter
constexpr double kSuspect = 4.0;          ///< medians; 6 sigma of normal noise
/// Below these no station is worth naming: a robot's repeatability.
constexpr double kLeastMedian_m = 5e-5;
constexpr double kLeastMedian_rad = 1e-4;

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
  for (const auto& [i, j, A, B, weight] : relativeMotions(pairs)) {
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

/// Noises from where `others` stations put one more that 99.8 % of clean sets keep below: their own noise is
/// estimated from what they leave over, and X_FC leans on them. From 1000 simulated sets of 5 to 15 stations.
double limitInNoises(std::size_t others) {
  return 5.5 * (1.0 + 17.0 * std::pow(static_cast<double>(others) - 2.0, -2.5));
}

/// Twelve numbers are fitted to six a station; three axes.
double axisNoise(double rms, std::size_t stations, double least) {
  const double share = 1.0 - 2.0 / static_cast<double>(stations);
  return std::max(rms / std::sqrt(3.0 * share), least);
}

std::vector<PosePair> without(std::span<const PosePair> pairs, std::span<const std::size_t> left_out) {
  std::vector<PosePair> kept;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (std::find(left_out.begin(), left_out.end(), i) == left_out.end()) kept.push_back(pairs[i]);
  return kept;
}

/// How far the suspects lie from where the others put them, in units of what is explained.
std::optional<std::vector<double>> strangeness(std::span<const PosePair> pairs,
                                               std::span<const std::size_t> suspects) {
  const auto others = without(pairs, suspects);
  const auto X_FC = tsaiLenzOverAllPairs(others);
  if (!X_FC) return std::nullopt;
  const auto misfit = stationMisfit(others, *X_FC);
  const double noise_m = axisNoise(misfit.rms_m(), others.size(), kLeastMedian_m);
  const double noise_rad = axisNoise(misfit.rms_rad(), others.size(), kLeastMedian_rad);
  std::vector<double> strange;
  for (const auto suspect : suspects) {
    const RigidTransform X_BM = pairs[suspect].X_BF * *X_FC * pairs[suspect].X_CM;
    const double shift_m = (X_BM.translation() - misfit.X_BM.translation()).norm();
    strange.push_back(std::max(shift_m / noise_m, angleBetween(X_BM, misfit.X_BM) / noise_rad) /
                      limitInNoises(others.size()));
  }
  return strange;
}

/// Clears one suspect after the other, the least strange first, until all that are left are strange.
std::vector<std::size_t> confirmed(std::span<const PosePair> pairs, std::vector<std::size_t> suspects) {
  while (!suspects.empty()) {
    const auto strange = strangeness(pairs, suspects);
    if (!strange) return {};
    const auto least = std::min_element(strange->begin(), strange->end());
    const bool are_others_few = pairs.size() - suspects.size() + 1 < kFewestToName;
    if (*least > 1.0 && !are_others_few) break;
    suspects.erase(suspects.begin() + (least - strange->begin()));
  }
  return suspects;
}

/// Stations by how much worse than the median one they fit, robustly.
std::optional<std::vector<double>> robustMisfit(std::span<const PosePair> pairs) {
  auto scaled = screwMismatch(pairs);
  for (int round = 0; round < kRounds; ++round) {
    const auto weights = softWeights(scaled);
    const auto X_FC = tsaiLenzOverAllPairs(pairs, weights);
    if (!X_FC) return std::nullopt;
    const auto misfit = stationMisfit(pairs, *X_FC, weights);
    scaled = inMedians(misfit.position_m, misfit.rotation_rad);
  }
  return scaled;
}

}  // namespace

std::vector<std::size_t> contradictingStations(std::span<const PosePair> pairs) {
  if (pairs.size() < kFewestToName) return {};
  const auto scaled = robustMisfit(pairs);
  if (!scaled) return {};
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < scaled->size(); ++i)
    if ((*scaled)[i] > kSuspect) suspects.push_back(i);
  return confirmed(pairs, suspects);
}

}  // namespace mirrorarm::calibration
