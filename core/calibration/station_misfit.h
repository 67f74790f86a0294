#pragma once

#include <span>
#include <vector>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// How far the calibration object strays from its mean pose, station by station, for one assumed X_FC.
struct StationMisfit {
  RigidTransform X_BM = RigidTransform::Identity();  ///< the (weighted) mean
  std::vector<double> position_m;
  std::vector<double> rotation_rad;

  [[nodiscard]] double rms_m() const;
  [[nodiscard]] double rms_rad() const;
};

/// `weights`: one a station, >= 0 and not all 0; empty for equal ones. At least one station.
[[nodiscard]] StationMisfit stationMisfit(std::span<const PosePair> pairs, const RigidTransform& X_FC,
                                          std::span<const double> weights = {});

/// Stations that contradict the others, by a robust fit of X_FC (Tsai-Lenz over all pairs with Geman-McClure
/// weights, started from how well the screws of robot and camera agree): misfit above 4 times the median one.
/// Indices ascend. Nothing is named where the fit fails.
[[nodiscard]] std::vector<std::size_t> contradictingStations(std::span<const PosePair> pairs);

}  // namespace mirrorarm::calibration
