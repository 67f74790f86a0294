#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::vision {

/// An ellipse in the raw image [px]; `angle_rad` from x to the major axis, towards y, in (-pi/2, pi/2].
struct Ellipse {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  double semi_major_px = 0.0;
  double semi_minor_px = 0.0;
  double angle_rad = 0.0;
};

/// One disc found in one raw image.
struct DetectedMarker {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< of the physical disc, not of the fitted ellipse
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Zero();
  Ellipse ellipse;                ///< its outline as fitted
  double outline_fraction = 0.0;  ///< share of the outline that edge points support, 0..1
};

/// Why a light is not a marker.
enum class Rejection { kTooSmall, kTooLarge, kTooElongated, kNotAnEllipse, kAtBorder, kSaturated, kCut };
inline constexpr std::size_t kRejectionCount = 7;

/// "too_small", ... as reports write it.
[[nodiscard]] std::string_view id(Rejection reason);

/// What one image holds.
struct Detection {
  std::vector<DetectedMarker> markers;
  std::array<int, kRejectionCount> rejected{};  ///< how many candidates fell to each reason
};

}  // namespace mirrorarm::vision
