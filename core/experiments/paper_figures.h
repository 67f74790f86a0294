#pragma once

namespace mirrorarm::experiments {

/// What the paper measured (sections 3.1 and 3.2), beside which our figures stand.
namespace paper {
inline constexpr double kStd_mm[] = {0.23, 0.23, 0.42};  ///< x, y, z of its whole system
inline constexpr double kReprojection_px = 0.29;         ///< of its stereo calibration
inline constexpr double kFitRms_mm = 0.21;               ///< +- 0.25
inline constexpr double kMostCovered = 0.5;  ///< "still able to register the point clouds correctly"
inline constexpr double kMean_ms = 9.42;     ///< pose estimation, 10 markers
inline constexpr double kStd_ms = 1.44;
inline constexpr double kLatency_ms = 318.70;  ///< onset of its robot's movement after the target's
}  // namespace paper

}  // namespace mirrorarm::experiments
