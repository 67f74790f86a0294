#include "core/vision/likelihood_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <Eigen/LU>

namespace mirrorarm::vision {
namespace {

constexpr double kMargin_px = 2.6;            // of ground above and below the outline: three and a half blurs
constexpr double kLeastMargin_px = 2.2;       // to its sides, where the width is a multiple of eight
constexpr int kEight = 8;                     // the fit takes pixels by eights
constexpr double kQuantisation = 1.0 / 12.0;  // grey^2, of rounding to whole grey values
constexpr double kShotNoise = 0.04;           // variance a grey level of light: 25 electrons a level
constexpr double kInsideShare = 0.98;
constexpr double kLeastSampledBlur_px = 0.6;  // a sharper rim falls between pixels,
constexpr double kUndersampled = 0.5;         // which moves it to and fro by so much of what it is sharper
constexpr double kMostInsideRatio = 3.0;
constexpr double kMostBlurOfRadius = 0.5;  // what is softer is a glow
constexpr double kBlurAllowance_px = 0.8;

constexpr double kLeastOddShare = 0.35;    // of the outline's deviations: a cover lies on one side
constexpr double kLeastRadiusOfCut = 4.0;  // blurs: in less light a cover cannot be told from another shape
constexpr std::size_t kDirections = 8;
constexpr std::array<double, 2> kGrowths{
    0.2, 0.6};  // of the visible part to the whole: a shallow cover, a deep one
constexpr std::size_t kPursued = 4;
constexpr double kSameDirection_rad = 0.2;
constexpr double kCoverGrowth =
    0.35;                            // of the radius: how much larger the whole disc is taken to be at first
constexpr double kLeastShown = 0.5;  // of the outline, below which the disc is a guess

/// Distance from an outline [blurs] at which a soft edge has fallen to `share` of its height: Hastings'
/// approximation of the normal quantile, Abramowitz and Stegun 26.2.23.
double quantile(double share) {
  const double t = std::sqrt(-2.0 * std::log(std::clamp(share, 1e-6, 0.5)));
  return t -
         (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

/// The symmetric matrix that takes an ellipse of that shape to the unit circle.
Eigen::Matrix2d unitMapOf(const Eigen::Matrix2d& shape) {
  // The root of a 2x2 matrix: (Q + sqrt(det) I) / sqrt(trace + 2 sqrt(det)).
  const double root_det = std::sqrt(std::max(shape.determinant(), 1e-12));
  const Eigen::Matrix2d root =
      (shape + root_det * Eigen::Matrix2d::Identity()) / std::sqrt(shape.trace() + 2.0 * root_det);
  return root.inverse();
}

Eigen::Matrix2d shapeOf(const BlurredDisc& disc) {
  const Eigen::Matrix2d axes = disc.B_per_px.inverse();
  return axes * axes;
}

/// The pixels around a disc that the fit looks at; nothing when the image is too small.
std::optional<Region> windowAround(const BlurredDisc& disc, const Region& frame) {
  const Eigen::Vector2d half = shapeOf(disc).diagonal().cwiseSqrt();
  const auto& c = disc.centre_px;
  const int width = static_cast<int>(std::ceil(2.0 * (half.x() + kLeastMargin_px) / kEight)) * kEight;
  if (!half.allFinite() || width > frame.width()) return std::nullopt;
  const int left = std::clamp(static_cast<int>(std::lround(c.x() - 0.5 * (width - 1))), frame.left,
                              frame.right + 1 - width);
  const Region window{left, std::max(static_cast<int>(std::floor(c.y() - half.y() - kMargin_px)), frame.top),
                      left + width - 1,
                      std::min(static_cast<int>(std::ceil(c.y() + half.y() + kMargin_px)), frame.bottom)};
  if (window.empty()) return std::nullopt;
  return window;
}

PixelNoise sensorNoise(const Light& light) {
  return {light.noise * light.noise + kQuantisation, kShotNoise * std::max(light.height(), 0.0)};
}

/// The smaller eigenvalue of a symmetric matrix.
double smallestOf(const Eigen::Matrix2d& matrix) {
  const double half = 0.5 * matrix.trace();
  return half - std::sqrt(std::max(half * half - matrix.determinant(), 0.0));
}

/// Covariance of (xx, xy, yy) of the shape Q = B^-2 from that of B.
Eigen::Matrix3d shapeCovariance(const BlurredDisc& disc, const Eigen::Matrix3d& of_B) {
  const Eigen::Matrix2d axes = disc.B_per_px.inverse();
  const Eigen::Matrix2d shape = axes * axes;
  Eigen::Matrix3d J;
  for (int k = 0; k < 3; ++k) {
    Eigen::Matrix2d change = Eigen::Matrix2d::Zero();
    change(k == 2 ? 1 : 0, k == 0 ? 0 : 1) = 1.0;
    change(k == 0 ? 0 : 1, k == 2 ? 1 : 0) = 1.0;
    const Eigen::Matrix2d moved = -(axes * change * shape + shape * change * axes);
    J.col(k) << moved(0, 0), moved(0, 1), moved(1, 1);
  }
  return J * of_B * J.transpose();
}

/// The disc that a visible part, fitted as if it were whole, may belong to when something covers it from
/// `direction_rad` on.
BlurredDisc coveredFrom(const BlurredDisc& visible, double direction_rad, double growth) {
  const Eigen::Vector2d towards(std::cos(direction_rad), std::sin(direction_rad));
  const Eigen::Matrix2d shape = shapeOf(visible);
  const double half_px = std::sqrt(towards.dot(shape * towards));
  const double growth_px = 0.5 * growth * half_px;
  BlurredDisc disc = visible;
  disc.centre_px += growth_px * towards;
  disc.B_per_px =
      unitMapOf(shape + (2.0 * half_px * growth_px + growth_px * growth_px) * towards * towards.transpose());
  disc.blur_px = visible.blur_px;
  disc.ramp_per_px.setZero();
  disc.covered = true;
  disc.cover_direction_rad = direction_rad;
  disc.cover_offset_px = half_px - growth_px;
  return disc;
}

/// A beginning and how far it has come.
struct CoverTry {
  double squares = 0.0;
  BlurredDisc disc;
};

/// True when both lead to the same cover.
bool alike(const CoverTry& a, const CoverTry& b) {
  const double turn = a.disc.cover_direction_rad - b.disc.cover_direction_rad;
  return std::cos(turn) > std::cos(kSameDirection_rad) &&
         std::abs(a.disc.cover_offset_px - b.disc.cover_offset_px) < 0.5;
}

}  // namespace

Expected<DetectedMarker, Rejection> LikelihoodEstimator::measure(const Brightness& image,
                                                                 const Light& light) {
  const BlurredDisc start = startOf(light);
  const auto window = windowAround(start, image.frame());
  if (!window) return unexpected(Rejection::kAtBorder);
  const auto fitted = fit_.fit(image, *window, start, sensorNoise(light));
  if (!fitted) return unexpected(Rejection::kCut);
  if (!follows(*fitted, light, image, *window))
    return unexpected(profile_.oddShare() < kLeastOddShare ? Rejection::kNotAnEllipse : Rejection::kCut);
  if (isSpeck(fitted->disc, light)) return unexpected(Rejection::kTooSmall);
  if (fitted->disc.blur_px > kBlurAllowance_px + kMostBlurOfRadius * std::sqrt(shapeOf(fitted->disc).trace()))
    return unexpected(Rejection::kNotAnEllipse);
  return withinLimits(markerOf(*fitted), settings_);
}

Expected<DetectedMarker, Rejection> LikelihoodEstimator::measureCut(const Brightness& image,
                                                                    const Light& light) {
  const BlurredDisc start = startOf(light);
  const auto window = windowAround(start, image.frame());
  if (!window) return unexpected(Rejection::kAtBorder);
  const auto fitted = fitCovered(image, *window, light);
  if (!fitted || !follows(*fitted, light, image, *window) || profile_.supported() < kLeastShown)
    return unexpected(Rejection::kCut);
  if (smallestOf(shapeOf(fitted->disc)) < std::pow(kLeastRadiusOfCut * settings_.blur_px, 2))
    return unexpected(Rejection::kCut);
  return withinLimits(markerOf(*fitted), settings_);
}

/// A disc with the light's moments, freed of the rim that its threshold let through.
BlurredDisc LikelihoodEstimator::startOf(const Light& light) const {
  const auto& component = light.component;
  const double height = std::max(light.height(), 1.0);
  const double rim_px = settings_.blur_px * quantile((component.threshold - light.ground) / height);
  const Eigen::Matrix2d shape = 4.0 * component.moments_px2();
  const double radius_px = std::pow(shape.determinant(), 0.25);
  const double share = std::clamp(1.0 - rim_px / radius_px, 0.4, 1.0);
  BlurredDisc disc;
  disc.centre_px = light.middle_px();
  disc.B_per_px = unitMapOf(share * share * shape);
  disc.blur_px = settings_.blur_px;
  disc.ground = light.ground;
  disc.light = height;
  return disc;
}

/// Shallow and deep covers from all sides are tried a few steps; the most promising ones are followed to the
/// end, and the likeliest is kept.
std::optional<FittedDisc> LikelihoodEstimator::fitCovered(const Brightness& image, const Region& window,
                                                          const Light& light) {
  const PixelNoise noise = sensorNoise(light);
  BlurredDisc visible = startOf(light);
  fit_.approach(image, window, noise, visible);
  std::array<CoverTry, kDirections * kGrowths.size()> tries;
  for (std::size_t i = 0; i < tries.size(); ++i) {
    const double direction_rad = 2.0 * std::numbers::pi * static_cast<double>(i % kDirections) / kDirections;
    tries[i].disc = coveredFrom(visible, direction_rad, kGrowths[i / kDirections]);
    tries[i].squares = fit_.approach(image, window, noise, tries[i].disc);
  }
  std::sort(tries.begin(), tries.end(),
            [](const CoverTry& a, const CoverTry& b) { return a.squares < b.squares; });
  std::optional<FittedDisc> best;
  double best_squares = std::numeric_limits<double>::infinity();
  std::size_t pursued = 0;
  for (std::size_t i = 0; i < tries.size() && pursued < kPursued && std::isfinite(tries[i].squares); ++i) {
    const auto before = std::span(tries).first(i);
    if (std::any_of(before.begin(), before.end(),
                    [&](const CoverTry& other) { return alike(other, tries[i]); }))
      continue;
    ++pursued;
    const auto fitted = fit_.fit(image, window, tries[i].disc, noise);
    if (!fitted || !fitted->settled) continue;
    BlurredDisc settled = fitted->disc;
    const double squares = fit_.approach(image, window, noise, settled);
    if (squares >= best_squares) continue;
    best_squares = squares;
    best = fitted;
  }
  return best;
}

/// True when outline and inside are as the fitted disc says.
bool LikelihoodEstimator::follows(const FittedDisc& fitted, const Light& light, const Brightness& image,
                                  const Region& window) {
  const PixelNoise noise = sensorNoise(light);
  const double radius_px = 1.0 / std::sqrt(fitted.disc.B_per_px.determinant());
  const double coarse_px = kUndersampled * std::max(kLeastSampledBlur_px - fitted.disc.blur_px, 0.0);
  profile_.measure(fitted.disc, noise, image, window,
                   std::hypot(settings_.outline_tolerance_px,
                              settings_.outline_tolerance_of_radius * radius_px, coarse_px));
  if (!fitted.settled || profile_.misfit() > 1.0) return false;
  const double texture = settings_.light_tolerance * fitted.disc.light;
  return profile_.insideVariance(kInsideShare) <
         kMostInsideRatio * (noise.dark + noise.lit + texture * texture);
}

/// A light hardly larger than the blur looks the same whatever made it, and its size and blur cannot be told
/// apart; but all its light over its peak is an area, and that is less than the least disc's.
bool LikelihoodEstimator::isSpeck(const BlurredDisc& disc, const Light& light) const {
  const double radius_px = 0.5 * settings_.min_diameter_px;
  const double sharpness = radius_px / settings_.blur_px;
  const double least_area_px2 =
      std::numbers::pi * radius_px * radius_px / (1.0 - std::exp(-0.5 * sharpness * sharpness));
  return std::numbers::pi * disc.light / disc.B_per_px.determinant() < least_area_px2 * light.height();
}

DetectedMarker LikelihoodEstimator::markerOf(const FittedDisc& fitted) const {
  DetectedMarker marker;
  marker.centre_px = fitted.centre_px;
  marker.covariance_px2 = fitted.centre_covariance_px2;
  marker.ellipse = ellipseOf(fitted.centre_px, shapeOf(fitted.disc));
  marker.shape_covariance_px4 = shapeCovariance(fitted.disc, fitted.covariance.block<3, 3>(kBxx, kBxx));
  marker.outline_fraction = profile_.supported();
  marker.cut = fitted.disc.covered;
  return marker;
}

}  // namespace mirrorarm::vision
