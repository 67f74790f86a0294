#pragma once

#include <array>
#include <cstdint>
#include <optional>
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

/// The symmetric matrix Q of (p - centre)^T Q^-1 (p - centre) = 1 [px^2]: what an affine map makes of the
/// unit circle, times its transpose.
[[nodiscard]] Eigen::Matrix2d shapeOf(const Ellipse& ellipse);
/// The ellipse around `centre_px` with that shape matrix.
[[nodiscard]] Ellipse ellipseOf(const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& shape_px2);

/// One disc found in one raw image.
struct DetectedMarker {
  /// Of the physical disc. Until the disc's normal is known it is the fitted ellipse's centre, which differs
  /// by the disc's eccentricity in a perspective image and by the lens's curvature, hundredths of a pixel.
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Zero();
  Ellipse ellipse;  ///< its outline as fitted, freed of the lens's blur; its centre stays uncorrected
  /// Covariance of (xx, xy, yy) of the outline's shape matrix.
  Eigen::Matrix3d shape_covariance_px4 = Eigen::Matrix3d::Zero();
  double outline_fraction = 0.0;  ///< share of the outline that the image supports, 0..1
  bool cut = false;               ///< something covers a part: fitted to the free outline, and less certain
};

/// Why a light is not a marker. kCut: a disc's outline but for one side, and what is left does not tell the
/// whole.
enum class Rejection { kTooSmall, kTooLarge, kTooElongated, kNotAnEllipse, kAtBorder, kSaturated, kCut };
inline constexpr std::size_t kRejectionCount = 7;

/// "too_small", ... as reports write it.
[[nodiscard]] std::string_view id(Rejection reason);

/// A light that is no marker.
struct RejectedLight {
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();  ///< its middle
  double extent_px = 0.0;                                 ///< its longer side
  Rejection reason = Rejection::kNotAnEllipse;
};

/// What the operator should mend about the light, the worst first.
enum class ExposureWarning : std::uint8_t {
  kSaturated,         ///< most markers are clipped at the sensor's upper end: expose shorter
  kBrightBackground,  ///< the ground is lit more than half: shut out daylight
  kTooDark,           ///< nothing stands out clearly: expose longer, or the cameras are covered
};
/// "saturated", "bright_background", "too_dark".
[[nodiscard]] std::string_view id(ExposureWarning warning);

/// How the image is lit, in grey values of what is looked for (the negative for dark dots).
struct Exposure {
  double background = 0.0;    ///< of the whole image: median over its parts
  double noise = 0.0;         ///< standard deviation in the ground
  double brightest = 0.0;     ///< of all lights
  int saturated_markers = 0;  ///< of which a good part is clipped
  std::optional<ExposureWarning> warning;
};

/// What one image holds.
struct Detection {
  std::vector<DetectedMarker> markers;
  std::array<int, kRejectionCount> rejected{};  ///< how many lights fell to each reason
  std::vector<RejectedLight> rejected_lights;   ///< the first kMostRejectedLights of them
  Exposure exposure;
};
inline constexpr std::size_t kMostRejectedLights = 256;

}  // namespace mirrorarm::vision
