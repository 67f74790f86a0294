#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

namespace mirrorarm::calibration {

/// vpHandEyeCalibration::calibrate with our types: X_FC from equally many X_CM and X_BF, or nothing where
/// ViSP gives up. Meanwhile the standard output of the whole process goes nowhere, because ViSP prints a
/// table at every call.
///
/// This header and its .cpp are C++17: the headers of ViSP 3.5 do not compile as C++20.
[[nodiscard]] std::optional<Eigen::Isometry3d> calibrateByVisp(const std::vector<Eigen::Isometry3d>& X_CM,
                                                               const std::vector<Eigen::Isometry3d>& X_BF);

}  // namespace mirrorarm::calibration
