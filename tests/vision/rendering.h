#pragma once

#include <random>
#include <vector>

#include <Eigen/Core>

#include "core/camera/image.h"

namespace mirrorarm::vision {

/// Draws what a sensor would see: area sampling on an eight times finer grid, Gaussian point spread, noise,
/// eight bits. Independent of the code under test.
class Rendering {
 public:
  Rendering(int width_px, int height_px, double background, double spread_px = 0.7);

  /// The ellipse centre + axes * u, |u| <= 1, brighter than the background by `level`.
  void disc(const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& axes_px, double level);
  void disc(const Eigen::Vector2d& centre_px, double diameter_px, double level);
  /// The same without the part beyond `cut_px` to the right of its centre.
  void cutDisc(const Eigen::Vector2d& centre_px, double diameter_px, double cut_px, double level);
  /// A bar through `centre_px` along `angle_rad`.
  void strip(const Eigen::Vector2d& centre_px, double length_px, double width_px, double angle_rad,
             double level);
  void speck(int x, int y, double level);

  /// The image with Gaussian noise of `sigma` grey values, rounded and clipped.
  [[nodiscard]] camera::GreyImage expose(double sigma, std::mt19937& random) const;

 private:
  template <class Inside>
  void add(const Eigen::Vector2d& centre_px, double reach_px, double level, Inside inside);

  int width_px_;
  int height_px_;
  std::vector<double> kernel_;
  std::vector<double> light_;
};

}  // namespace mirrorarm::vision
