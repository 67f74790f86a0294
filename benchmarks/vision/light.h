#pragma once

#include <vector>

#include "benchmarks/trial_random.h"
#include "benchmarks/vision/outline.h"
#include "core/camera/image.h"

namespace mirrorarm::benchmarks::vision {

/// Grey values before noise and rounding.
struct Light {
  Light(int width, int height, double background)
      : width_px(width),
        height_px(height),
        grey(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

  [[nodiscard]] double& at(int x, int y) {
    return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                static_cast<std::size_t>(x)];
  }

  int width_px = 0, height_px = 0;
  std::vector<double> grey;
};

/// Brightness of a surface: level * (1 + slope . (p - origin)).
struct Shading {
  double level = 0.0;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< [1/px]
};

/// Adds the surface inside the outline as a lens with a Gaussian point spread and square pixels shows it.
/// Exact: by Green's theorem the light in a pixel is an integral around the outline, with the antiderivative
/// along x of the shading times the point spread in closed form.
void addSurface(Light& light, const Outline& outline, double spread_px, const Shading& shading);

/// With white noise of `sigma` grey values, rounded to 8 bits and clipped; 0 only rounds.
[[nodiscard]] camera::GreyImage exposed(const Light& light, double sigma, TrialRandom& random);

}  // namespace mirrorarm::benchmarks::vision
