#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "benchmarks/vision/noise_table.h"
#include "core/camera/image.h"

namespace mirrorarm::benchmarks::vision {

/// What shines in a frame and is no marker.
enum class Shape { kDisc, kStrip, kRectangle, kBigDisc, kSpeck, kAngle };
[[nodiscard]] std::string_view id(Shape shape);

/// One light of a frame.
struct PlacedLight {
  Shape shape = Shape::kDisc;
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  double size_px = 0.0;    ///< major diameter, or longer side
  double slimness = 1.0;   ///< minor to major axis, or shorter to longer side
  double contrast = 0.0;   ///< grey values over the ground
  double radius_px = 0.0;  ///< of the circle that holds it
};

struct SpuriousFrame {
  camera::GreyImage image;
  std::vector<PlacedLight> lights;
  double noise = 0.0;  ///< standard deviation [grey]
};

/// Makes frames of 640 x 480 with ten discs (diameter 6 to 20 px, axis ratio 0.5 to 1) and twenty spurious
/// reflections: strips, rectangles, big discs, specks of 1 to 2 px, L-shapes, all of contrast 40 to 200, SNR
/// 20 to 100, at least 6 px apart and 4 px inside the image. Shapes come rendered from a stock at random
/// fractions of a pixel. Any frame can be made again alone. Use by several threads.
class SpuriousScene {
 public:
  explicit SpuriousScene(bool small_stock);

  [[nodiscard]] SpuriousFrame frame(std::uint64_t index) const;

  static constexpr int kWidth_px = 640, kHeight_px = 480;
  static constexpr int kDiscs = 10, kSpurious = 20;

 private:
  /// A shape of contrast 1 in a small square.
  struct Stamp {
    PlacedLight light;  ///< its centre in the square
    int side_px = 0;
    std::vector<float> share;
  };
  [[nodiscard]] const Stamp& anyOf(const std::vector<Stamp>& stamps, double choice) const;
  [[nodiscard]] camera::GreyImage expose(const std::vector<float>& light, double noise,
                                         std::uint64_t index) const;

  std::vector<Stamp> discs_;
  std::vector<Stamp> spurious_;
  NoiseTable normal_;
};

}  // namespace mirrorarm::benchmarks::vision
