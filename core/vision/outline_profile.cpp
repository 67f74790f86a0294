#include "core/vision/outline_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace mirrorarm::vision {
namespace {

constexpr double kSectorLength_px = 1.3;
constexpr int kFewestSectors = 12;
constexpr double kLeastSlope = 0.02;  // of the light a blur: what is farther from the rim says nothing of it
constexpr double kUncertain = 3.0;
constexpr double kSigmas = 5.0;
constexpr double kShapeParameters = 5.0;

/// Position around the unit circle, 0..4 for a turn, without trigonometry: quarter by quarter along the
/// diamond |x| + |y| = 1.
float diamondAngle(float x, float y) {
  const float sum = std::abs(x) + std::abs(y) + 1e-20F;
  if (y >= 0.0F) return x >= 0.0F ? y / sum : 1.0F - x / sum;
  return x < 0.0F ? 2.0F - y / sum : 3.0F + x / sum;
}

/// The point of the unit circle in the middle of a sector.
Eigen::Vector2d middleOf(int sector, int count) {
  const double at = 4.0 * (sector + 0.5) / count;
  const double within = at - std::floor(at);
  const Eigen::Vector2d diamond(1.0 - within, within);
  const double quarter = 0.5 * std::numbers::pi * std::floor(at);
  const double c = std::cos(quarter), s = std::sin(quarter);
  return Eigen::Vector2d(c * diamond.x() - s * diamond.y(), s * diamond.x() + c * diamond.y()).normalized();
}

bool isCovered(const BlurredDisc& disc, const Eigen::Matrix2d& axes, int sector, int count) {
  if (!disc.covered) return false;
  const Eigen::Vector2d direction(std::cos(disc.cover_direction_rad), std::sin(disc.cover_direction_rad));
  return direction.dot(axes * middleOf(sector, count)) > disc.cover_offset_px;
}

}  // namespace

void OutlineProfile::measure(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
                             const Region& window, double tolerance_px) {
  residuals(disc, noise, image, window, left_over_);
  const double radius_px = 1.0 / std::sqrt(disc.B_per_px.determinant());
  const double circumference_px = 2.0 * std::numbers::pi * radius_px;
  count_ = std::clamp(4 * static_cast<int>(circumference_px / kSectorLength_px / 4.0), kFewestSectors,
                      kMostSectors);
  sumUp(disc, noise);
  judge(disc, tolerance_px);
}

void OutlineProfile::sumUp(const BlurredDisc& disc, const PixelNoise& noise) {
  const auto least_slope = static_cast<float>(kLeastSlope * disc.light / disc.blur_px);
  weight_.fill(0.0);
  displacement_.fill(0.0);
  const auto& left = left_over_;
  const auto scale = static_cast<float>(count_) / 4.0F;
  for (std::size_t i = 0; i < left.residual.size(); ++i) {
    if (left.slope[i] < least_slope || left.residual[i] == 0.0F) continue;
    const int sector = std::min(static_cast<int>(diamondAngle(left.ux[i], left.uy[i]) * scale), count_ - 1);
    const double variance = noise.dark + noise.lit * left.share[i];
    weight_[static_cast<std::size_t>(sector)] += left.slope[i] * left.slope[i] / variance;
    displacement_[static_cast<std::size_t>(sector)] += left.slope[i] * left.residual[i] / variance;
  }
}

double OutlineProfile::insideVariance(double share) const {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < left_over_.residual.size(); ++i) {
    if (left_over_.share[i] < share) continue;
    sum += left_over_.residual[i] * left_over_.residual[i];
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double OutlineProfile::oddShare() const {
  double odd = 0.0, all = 0.0;
  for (int k = 0, half = count_ / 2; k < half; ++k) {
    const double one = displacement_px(k), other = displacement_px(k + half);
    odd += 0.5 * (one - other) * (one - other);
    all += one * one + other * other;
  }
  return all > 0.0 ? odd / all : 0.0;
}

void OutlineProfile::judge(const BlurredDisc& disc, double tolerance_px) {
  const Eigen::Matrix2d axes = disc.B_per_px.inverse();
  const double allowed = tolerance_px * tolerance_px;
  double sum = 0.0;
  int free = 0, in_place = 0;
  for (int k = 0; k < count_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (weight_[at] <= 0.0 || isCovered(disc, axes, k, count_)) {
      displacement_[at] = 0.0;
      continue;
    }
    displacement_[at] /= weight_[at];
    const double variance = 1.0 / weight_[at] + allowed;
    const double normalised = displacement_[at] * displacement_[at] / variance;
    sum += normalised;
    ++free;
    in_place += normalised <= kUncertain * kUncertain ? 1 : 0;
  }
  const double freedom = std::max(free - kShapeParameters, 1.0);
  misfit_ = sum / (freedom + kSigmas * std::sqrt(2.0 * freedom));
  supported_ = static_cast<double>(in_place) / count_;
}

}  // namespace mirrorarm::vision
