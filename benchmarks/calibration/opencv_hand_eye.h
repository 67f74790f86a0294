#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::benchmarks::calibration {

inline constexpr std::size_t kOpenCvMethods = 5;
inline constexpr std::array<const char*, kOpenCvMethods> kOpenCvMethodNames = {
    "OpenCV Tsai", "Park", "Horaud", "Andreff", "Daniilidis"};

/// X_FC by OpenCV's method `i`; not finite numbers are passed on. Nothing where it throws.
[[nodiscard]] std::optional<RigidTransform> handEyeByOpenCv(
    std::size_t i, std::span<const mirrorarm::calibration::PosePair> pairs);

}  // namespace mirrorarm::benchmarks::calibration
