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

  /// Root mean square over the stations, each counted by its weight; empty for equal ones.
  [[nodiscard]] double rms_m(std::span<const double> weights = {}) const;
  [[nodiscard]] double rms_rad(std::span<const double> weights = {}) const;
};

/// `weights`: one a station, >= 0 and not all 0; empty for equal ones. At least one station.
[[nodiscard]] StationMisfit stationMisfit(std::span<const PosePair> pairs, const RigidTransform& X_FC,
                                          std::span<const double> weights = {});

}  // namespace mirrorarm::calibration
