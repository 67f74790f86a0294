#pragma once

#include <array>

#include "core/vision/blurred_disc.h"

namespace mirrorarm::vision {

/// How well the image's outline follows a fitted disc, sector by sector around it: the displacement of the
/// outline, outwards, that the residuals of a sector ask for. A disc that something covers, or a light that
/// is no disc, shows here.
class OutlineProfile {
 public:
  static constexpr int kMostSectors = 32;

  /// `noise` is what the sensor makes, not what the fit left over; `tolerance_px` is what a real disc's
  /// outline may deviate.
  void measure(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
               const Region& window, double tolerance_px);

  /// Sum of squared displacements by their variance and the tolerance's, against the number of sectors: near
  /// 0 for a disc, above 1 when the outline is not the disc's (5 standard deviations).
  [[nodiscard]] double misfit() const { return misfit_; }
  /// Share of the outline that the image supports: sectors in place, not covered.
  [[nodiscard]] double supported() const { return supported_; }
  /// Share of the squared displacements that changes its sign from one side to the other: near 0 for what
  /// looks the same when turned by half, as rectangles and strips do, more where one side is covered.
  [[nodiscard]] double oddShare() const;

  /// Mean of the squared residuals [grey^2] where at least `share` of the light is full; 0 when nowhere.
  [[nodiscard]] double insideVariance(double share) const;

  [[nodiscard]] int sectors() const { return count_; }
  /// Of sector `k` [px]; its middle is k / sectors() of a turn from B's x axis.
  [[nodiscard]] double displacement_px(int k) const { return displacement_[static_cast<std::size_t>(k)]; }

 private:
  void sumUp(const BlurredDisc& disc, const PixelNoise& noise);
  void judge(const BlurredDisc& disc, double tolerance_px);

  DiscResiduals left_over_;
  int count_ = 0;
  std::array<double, kMostSectors> weight_{};
  std::array<double, kMostSectors> displacement_{};
  double misfit_ = 0.0;
  double supported_ = 0.0;
};

}  // namespace mirrorarm::vision
