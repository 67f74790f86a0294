#pragma once

#include "benchmarks/vision/disc.h"

namespace mirrorarm::benchmarks::vision {

/// Least standard deviation per axis of a centre estimated without bias [px], from one noisy image.
struct CentreBound {
  double centre_alone = 0.0;     ///< everything but the centre known
  double blurred_ellipse = 0.0;  ///< shape, background, contrast and blur unknown too: 8 parameters
  double with_ramp = 0.0;        ///< a linear ramp of the reflectance as well: 10 parameters
};

/// Cramer-Rao bound for white noise of `sigma` grey values: the Fisher information of this very disc's
/// pixels, from finite differences of the noise-free rendering.
[[nodiscard]] CentreBound centreBound(const Disc& disc, double sigma);

/// The bound in closed form, (1/SNR) sqrt(4 s_b / (sqrt(pi) D_eff)): a straight edge's information around the
/// outline. s_b holds the lens's spread and the pixel's own, sqrt(spread^2 + 1/12); D_eff is the diameter of
/// the circle that is as good as the ellipse, on average over both axes.
[[nodiscard]] double centreBoundFormula(const Disc& disc, double sigma);

}  // namespace mirrorarm::benchmarks::vision
