#pragma once

#include <optional>

#include "core/vision/blurred_disc.h"

namespace mirrorarm::vision {

/// A disc fitted to its pixels.
struct FittedDisc {
  BlurredDisc disc;
  bool settled = true;  ///< false: the best of many steps, of which the last still went downhill
  DiscMatrix covariance = DiscMatrix::Zero();           ///< of the parameters, in the order of DiscParameter
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< averaged over "a ramp" and "no ramp"
  Eigen::Matrix2d centre_covariance_px2 = Eigen::Matrix2d::Zero();
};

/// Maximum-likelihood fit of a BlurredDisc: Gauss-Newton steps with analytic derivatives, damped after
/// Levenberg and Marquardt where they do not go downhill. The noise is learnt from what the fit leaves over:
/// a variance in the ground and one where the disc is lit, as shot noise makes it.
///
/// A ramp that is always fitted costs precision where there is none, and one that is never fitted a bias
/// where there is; so both answers are averaged by how probable the pixels make them (Bayesian model
/// averaging, prior of a ramp as in kRampPrior). One thread.
class LikelihoodFit {
 public:
  /// What is known of the lens's blur before: `blur_px` give or take `blur_tolerance_px`.
  LikelihoodFit(double blur_px, double blur_tolerance_px)
      : blur_px_(blur_px), blur_weight_(1.0 / (blur_tolerance_px * blur_tolerance_px)) {}

  /// From `start` and what the sensor's noise may be. Nothing when the steps do not lead to a disc.
  [[nodiscard]] std::optional<FittedDisc> fit(const Brightness& image, const Region& window,
                                              const BlurredDisc& start, const PixelNoise& noise);

  /// A few steps only, with `noise` as it is: the sum of squares that `disc` then has. For choosing between
  /// several beginnings. Infinite when they do not lead to a disc.
  double approach(const Brightness& image, const Region& window, const PixelNoise& noise, BlurredDisc& disc);

 private:
  struct Descent {
    int most_steps;
    bool learn_noise;
  };
  bool descend(const Brightness& image, const Region& window, const Descent& how, BlurredDisc& disc);

  [[nodiscard]] double certaintyOfNoise() const;
  void addPriors(const BlurredDisc& disc, DiscEquations& equations) const;

  double blur_px_;
  double blur_weight_;
  PixelNoise noise_;
  DiscEquations equations_;
  double squares_ = 0.0;
};

}  // namespace mirrorarm::vision
