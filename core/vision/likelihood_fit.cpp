#include "core/vision/likelihood_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include "core/vision/small_cholesky.h"

namespace mirrorarm::vision {
namespace {

constexpr int kMostSteps = 24;
constexpr int kFewSteps = 4;
constexpr double kSettled = 0.1;  // predicted fall of the sum of squares: a third of a sigma, before the step
constexpr double kNear = 0.2;     // the same a pixel: then most of what is left over is noise
constexpr double kNearShare = 0.05;  // the same of the sum of squares, for lights that are no discs
constexpr double kHopeless =
    25.0;  // times the sensor's variance: no disc, whose exact place matters to nobody
constexpr double kSettledShare = 1e-3;  // of the sum of squares
constexpr double kStudent = 6.0;        // twice three: of n / 3 degrees of freedom
constexpr double kLeastDamping = 1e-3;
constexpr double kMostDampingAtEnd = 0.1;
constexpr double kQuantisation = 1.0 / 12.0;  // grey^2
constexpr double kLeastBlur_px = 0.3;
constexpr double kMostBlur_px = 6.0;
constexpr double kRampPrior = 0.1;  // end to end over the disc, in shares of its light
constexpr double kRampOdds = 0.02;  // of there being one that matters
constexpr double kMostRamp = 0.8;

BlurredDisc moved(const BlurredDisc& disc, const DiscVector& step) {
  BlurredDisc next = disc;
  next.centre_px += step.segment<2>(kCentreX);
  next.B_per_px(0, 0) += step(kBxx);
  next.B_per_px(0, 1) += step(kBxy);
  next.B_per_px(1, 0) += step(kBxy);
  next.B_per_px(1, 1) += step(kByy);
  next.blur_px = std::clamp(disc.blur_px + step(kBlur), std::max(kLeastBlur_px, 0.6 * disc.blur_px),
                            std::min(kMostBlur_px, 1.6 * disc.blur_px));
  next.ground += step(kGround);
  next.light += step(kLight);
  if (disc.covered) {
    next.cover_direction_rad += step(kExtra1);
    next.cover_offset_px += step(kExtra2);
  } else {
    next.ramp_per_px += step.segment<2>(kExtra1);
  }
  return next;
}

/// The step cut so that the disc neither leaps nor changes its size by more than a third.
DiscVector bounded(const BlurredDisc& disc, DiscVector step) {
  const double size = disc.B_per_px.norm();
  const double share = std::max({step.segment<3>(kBxx).cwiseAbs().maxCoeff() / (0.3 * size),
                                 step.segment<2>(kCentreX).norm() * size / 0.8, 1.0});
  return step / share;
}

bool isADisc(const BlurredDisc& disc, const Region& window) {
  const auto& B = disc.B_per_px;
  const auto& c = disc.centre_px;
  return B.allFinite() && c.allFinite() && B(0, 0) > 0.0 && B.determinant() > 0.0 && disc.light > 0.0 &&
         c.x() > window.left && c.x() < window.right && c.y() > window.top && c.y() < window.bottom;
}

/// Straight line of squared residuals over the share of light: noise in the ground, and more in the light.
PixelNoise learnt(const DiscEquations& sums) {
  const double freedom = sums.pixels / std::max(sums.pixels - kDiscParameters, 1.0);
  const double spread = std::max(sums.pixels * sums.share2 - sums.share * sums.share, 1e-9);
  const double lit = freedom * (sums.pixels * sums.share_square - sums.share * sums.square) / spread;
  const double dark = (freedom * sums.square - lit * sums.share) / std::max(sums.pixels, 1.0);
  PixelNoise noise;
  noise.dark = std::max(dark, kQuantisation);
  noise.lit = std::max(lit, kQuantisation - noise.dark);
  return noise;
}

/// Both answers, with a ramp and without, weighted by their probability.
void averageOverRamp(const BlurredDisc& disc, const DiscMatrix& covariance, FittedDisc& fitted) {
  const Eigen::Matrix2d of_ramp = covariance.block<2, 2>(kExtra1, kExtra1);
  const Eigen::Matrix2d centre_and_ramp = covariance.block<2, 2>(kCentreX, kExtra1);
  const Eigen::Matrix2d gain = centre_and_ramp * of_ramp.inverse();
  const Eigen::Vector2d without = -gain * disc.ramp_per_px;  // step of the centre when the ramp is none
  const double radius_px = 1.0 / std::sqrt(disc.B_per_px.determinant());
  const double prior = kRampPrior * disc.light / (2.0 * radius_px);
  const Eigen::Matrix2d spread = of_ramp + prior * prior * Eigen::Matrix2d::Identity();
  const auto square = [&](const Eigen::Matrix2d& matrix) {
    return disc.ramp_per_px.dot(matrix.inverse() * disc.ramp_per_px);
  };
  const double log_odds = std::log(kRampOdds) + 0.5 * (square(of_ramp) - square(spread)) +
                          0.5 * std::log(of_ramp.determinant() / spread.determinant());
  const double ramp_share = 1.0 / (1.0 + std::exp(-std::clamp(log_odds, -50.0, 50.0)));
  const double none_share = 1.0 - ramp_share;
  fitted.centre_px = disc.centre_px + none_share * without;
  const Eigen::Matrix2d with_ramp = covariance.block<2, 2>(kCentreX, kCentreX);
  const Eigen::Matrix2d no_ramp = with_ramp - gain * centre_and_ramp.transpose();
  fitted.centre_covariance_px2 =
      ramp_share * with_ramp + none_share * no_ramp + ramp_share * none_share * without * without.transpose();
}

}  // namespace

std::optional<FittedDisc> LikelihoodFit::fit(const Brightness& image, const Region& window,
                                             const BlurredDisc& start, const PixelNoise& noise) {
  noise_ = noise;
  FittedDisc fitted;
  fitted.disc = start;
  fitted.settled = descend(image, window, {kMostSteps, true}, fitted.disc);
  SmallCholesky<kDiscParameters> factor;
  if (!factor.factorise(equations_.matrix)) return std::nullopt;
  fitted.covariance = certaintyOfNoise() * factor.inverse();
  if (!fitted.covariance.allFinite() || !isADisc(fitted.disc, window)) return std::nullopt;
  fitted.centre_px = fitted.disc.centre_px;
  fitted.centre_covariance_px2 = fitted.covariance.block<2, 2>(kCentreX, kCentreX);
  if (!fitted.disc.covered) averageOverRamp(fitted.disc, fitted.covariance, fitted);
  return fitted;
}

/// Factor from the covariance under the weights to the honest one: the weights were learnt one step earlier,
/// and the noise that acts on the rim is known from a third of the pixels only, which widens the distribution
/// as Student's does.
double LikelihoodFit::certaintyOfNoise() const {
  const PixelNoise found = learnt(equations_);
  const double widening = equations_.pixels / std::max(equations_.pixels - kStudent, 1.0);
  return widening * (found.dark + 0.5 * found.lit) / (noise_.dark + 0.5 * noise_.lit);
}

double LikelihoodFit::approach(const Brightness& image, const Region& window, const PixelNoise& noise,
                               BlurredDisc& disc) {
  noise_ = noise;
  return descend(image, window, {kFewSteps, false}, disc) ? squares_
                                                          : std::numeric_limits<double>::infinity();
}

/// Knowledge from elsewhere: what the lens's blur usually is, and that ramps are bounded. It keeps discs of a
/// few pixels, which cannot tell all parameters apart, from running away.
void LikelihoodFit::addPriors(const BlurredDisc& disc, DiscEquations& equations) const {
  const double excess_px = disc.blur_px - blur_px_;
  equations.matrix(kBlur, kBlur) += blur_weight_;
  equations.vector(kBlur) -= blur_weight_ * excess_px;
  equations.squares += blur_weight_ * excess_px * excess_px;
  if (disc.covered) return;
  const double radius_px = 1.0 / std::sqrt(std::abs(disc.B_per_px.determinant()));
  const double most = kMostRamp * disc.light / (2.0 * radius_px);
  const double weight = 1.0 / (most * most + 1e-12);
  equations.matrix.diagonal().segment<2>(kExtra1).array() += weight;
  equations.vector.segment<2>(kExtra1) -= weight * disc.ramp_per_px;
  equations.squares += weight * disc.ramp_per_px.squaredNorm();
}

bool LikelihoodFit::descend(const Brightness& image, const Region& window, const Descent& how,
                            BlurredDisc& disc) {
  BlurredDisc trial = disc;
  DiscEquations at_trial;
  equations_.matrix.setZero();
  SmallCholesky<kDiscParameters> factor;
  double damping = 0.0;
  bool comparable = false;  // sums of squares, which hang on the noise
  bool noise_known = !how.learn_noise;
  double enough = kSettled;
  for (int step = 0; step < how.most_steps; ++step) {
    const bool valid = isADisc(trial, window);
    if (valid) {
      normalEquations(trial, noise_, image, window, at_trial);
      addPriors(trial, at_trial);
    }
    if (valid && (!comparable || at_trial.squares <= squares_)) {
      squares_ = at_trial.squares;
      disc = trial;
      std::swap(equations_, at_trial);
      damping = damping > kLeastDamping ? 0.1 * damping : 0.0;
      comparable = true;
    } else if (comparable) {
      damping = std::max(10.0 * damping, 10.0 * kLeastDamping);
    } else {
      return false;
    }
    if (!factor.factorise(equations_.matrix, damping)) return false;
    DiscVector change = bounded(disc, factor.solve(equations_.vector));
    trial = moved(disc, change);
    change(kBlur) = trial.blur_px - disc.blur_px;  // which has limits
    const double fall = change.dot(equations_.vector);
    if (damping > kMostDampingAtEnd) continue;
    if (noise_known && fall < enough && isADisc(trial, window)) {
      disc = trial;
      return true;
    }
    if (!noise_known && fall < std::max(kNear * equations_.pixels, kNearShare * squares_)) {
      const PixelNoise given = std::exchange(noise_, learnt(equations_));
      if (noise_.dark + noise_.lit > kHopeless * (given.dark + given.lit)) enough = kSettledShare * squares_;
      noise_known = true;
      comparable = false;
    }
  }
  return noise_known;
}

}  // namespace mirrorarm::vision
