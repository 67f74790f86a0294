#pragma once

#include <optional>

#include <Eigen/Core>

#include "benchmarks/trial_random.h"
#include "benchmarks/vision/light.h"
#include "benchmarks/vision/outline.h"

namespace mirrorarm::benchmarks::vision {

/// One disc in a small image of its own: the truth of a trial.
struct Disc {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Matrix2d axes_px = Eigen::Matrix2d::Identity();  ///< symmetric: centre + axes * u, |u| <= 1
  double background = 12.0;
  double contrast = 180.0;
  double spread_px = 0.7;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< of the reflectance, see Shading [1/px]
  std::optional<Cut> cut;
};

/// Side of the image around a disc.
inline constexpr int kDiscImage_px = 80;

/// A disc of that major diameter near the image's middle: random place between pixels, axis ratio and angle.
[[nodiscard]] Disc randomDisc(double diameter_px, double least_ratio, TrialRandom& random);

[[nodiscard]] Light lightOf(const Disc& disc, int side_px = kDiscImage_px);

}  // namespace mirrorarm::benchmarks::vision
