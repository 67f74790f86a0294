#include "core/vision/disc_fit.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace mirrorarm::vision {
namespace {

constexpr std::size_t kMostSectors = 32;
constexpr double kSectorLength_px = 1.6;
constexpr double kDetectorBlur_px2 =
    1.0 / 3.0 + 1.0 / 12.0;  // of central differences and of a pixel's own area
constexpr double kLeastGate_px = 0.15;
constexpr double kQuantisation = 1.0 / 12.0;  // variance of rounding to whole grey values
constexpr double kRmsOfRadius = 0.1;          // a small outline must fit better than the settings ask

/// Radius of a disc whose edge, blurred by a Gaussian, shows its steepest slope at `radius`: smoothing draws
/// the outline of a small disc inwards. Fits the exact relation to 2 %; 0 for what is no larger than the blur
/// itself.
double unblurred(double radius, double sigma2) {
  const double r2 = radius * radius / sigma2;
  return r2 > 1.0 ? std::sqrt(sigma2 * (r2 - 1.0)) * (r2 + 1.0) / r2 : 0.0;
}

void undoBlur(Ellipse& ellipse, double sigma_px) {
  const double radius = std::sqrt(ellipse.semi_major_px * ellipse.semi_minor_px);
  if (!(radius > 0.0)) return;
  const double scale = unblurred(radius, sigma_px * sigma_px + kDetectorBlur_px2) / radius;
  ellipse.semi_major_px *= scale;
  ellipse.semi_minor_px *= scale;
}

/// Ramanujan's first approximation.
double circumference(const Ellipse& ellipse) {
  const double a = ellipse.semi_major_px;
  const double b = ellipse.semi_minor_px;
  return std::numbers::pi * (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b)));
}

Eigen::Vector2d meanOf(std::span<const EdgePoint> outline) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& edge : outline) sum += edge.position_px.cast<double>();
  return sum / static_cast<double>(outline.size());
}

/// Variance of one edge point along its normal: what the image's noise makes of it, or what the fit left over
/// where that is more.
double pointVariance(std::span<const EdgePoint> outline, double noise, double sigma_px, double rms) {
  // White noise after the second derivative of a Gaussian has the variance 3 / (16 pi sigma^6); the third
  // derivative of the edge turns it into pixels.
  const double gain = 3.0 / (16.0 * std::numbers::pi * std::pow(sigma_px, 6));
  double sharpness = 0.0;
  for (const auto& edge : outline) sharpness += edge.sharpness;
  sharpness /= static_cast<double>(outline.size());
  return std::max((noise * noise + kQuantisation) * gain / (sharpness * sharpness), rms * rms);
}

/// How many edge points stand for one independent one: those under one Gaussian share its noise, which makes
/// it correlated over 2 sqrt(pi) sigma along the outline.
double pointsPerIndependent(double points, double length_px, double sigma_px) {
  const double independent = std::max(1.0, length_px / (2.0 * std::sqrt(std::numbers::pi) * sigma_px));
  return std::max(1.0, points / independent);
}

std::optional<Rejection> refuse(const DetectedMarker& marker, double rms, const FinderSettings& settings) {
  const double a = marker.ellipse.semi_major_px;
  const double b = marker.ellipse.semi_minor_px;
  if (2.0 * a < settings.min_diameter_px) return Rejection::kTooSmall;
  if (2.0 * a > settings.max_diameter_px) return Rejection::kTooLarge;
  if (a > settings.max_axis_ratio * b) return Rejection::kTooElongated;
  if (rms > std::min(settings.max_fit_rms_px, kRmsOfRadius * (1.0 + b))) return Rejection::kNotAnEllipse;
  const double sigma2 = marker.covariance_px2.diagonal().maxCoeff();
  if (!(sigma2 <= settings.max_centre_sigma_px * settings.max_centre_sigma_px))
    return Rejection::kNotAnEllipse;
  if (marker.outline_fraction < settings.min_outline_fraction) return Rejection::kCut;
  return std::nullopt;
}

}  // namespace

Expected<DetectedMarker, Rejection> DiscFit::fit(std::span<const EdgePoint> outline,
                                                 const camera::CameraModel* camera, double noise,
                                                 double sigma_px) {
  if (outline.empty()) return unexpected(Rejection::kNotAnEllipse);
  const auto plane = FitPlane::around(camera, meanOf(outline));
  if (!plane || !carryTo(*plane, outline)) return unexpected(Rejection::kNotAnEllipse);
  const auto direct = fitDirect(points_);
  const auto fitted = direct ? refiner_.refine(*direct, points_, kLeastGate_px, supports_) : std::nullopt;
  Eigen::Matrix2d J;
  const auto centre_px = fitted ? plane->toPixel(fitted->ellipse.centre, J) : std::nullopt;
  if (!centre_px) return unexpected(Rejection::kNotAnEllipse);

  DetectedMarker marker;
  marker.centre_px = *centre_px;
  const Eigen::Matrix2d axes = J * fitted->ellipse.axes;
  marker.ellipse = ellipseOf(*centre_px, axes * axes.transpose());
  const double length_px = circumference(marker.ellipse);
  marker.outline_fraction = supportedShare(fitted->ellipse, length_px);
  undoBlur(marker.ellipse, sigma_px);
  const auto supporting = static_cast<double>(std::count(supports_.begin(), supports_.end(), 1));
  marker.covariance_px2 = pointVariance(outline, noise, sigma_px, fitted->rms) *
                          pointsPerIndependent(supporting, length_px, sigma_px) * J * fitted->cofactor *
                          J.transpose();
  if (const auto reason = refuse(marker, fitted->rms, settings_)) return unexpected(*reason);
  return marker;
}

bool DiscFit::carryTo(const FitPlane& plane, std::span<const EdgePoint> outline) {
  points_.clear();
  for (const auto& edge : outline) {
    const auto point = plane.fromPixel(edge.position_px.cast<double>());
    if (!point) return false;
    points_.push_back(*point);
  }
  return true;
}

double DiscFit::supportedShare(const EllipseMap& ellipse, double length_px) const {
  // Every sector of a whole outline must hold a point: a short outline has few.
  const auto count =
      std::clamp(static_cast<std::size_t>(length_px / kSectorLength_px), std::size_t{4}, kMostSectors);
  std::bitset<kMostSectors> sectors;
  const Eigen::Matrix2d inverse_axes = ellipse.axes.inverse();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (supports_[i] == 0) continue;
    const Eigen::Vector2d u = inverse_axes * (points_[i] - ellipse.centre);
    const double turn = std::atan2(u.y(), u.x()) / (2.0 * std::numbers::pi) + 0.5;
    sectors.set(std::min(static_cast<std::size_t>(turn * static_cast<double>(count)), count - 1));
  }
  return static_cast<double>(sectors.count()) / static_cast<double>(count);
}

}  // namespace mirrorarm::vision
