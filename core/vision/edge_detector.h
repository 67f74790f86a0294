#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/vision/brightness.h"

namespace mirrorarm::vision {

/// A point of an edge between pixels.
struct EdgePoint {
  Eigen::Vector2f position_px;  ///< in the image
  Eigen::Vector2f
      gradient;  ///< towards the bright side [grey/px], of the image smoothed at the detector's scale
  float sharpness = 0.0F;  ///< -L_vvv, how steeply the second derivative crosses zero [grey/px^3]
  int contour = 0;         ///< points of one contour carry the same number
};

/// Gradients that make an edge: one point of a contour must reach `strong`, all of them `weak`.
struct EdgeThresholds {
  float strong = 0.0F;
  float weak = 0.0F;
};

/// Canny's edge detector with differential non-maximum suppression: smoothed by a Gaussian, edges lie where
/// the second derivative along the gradient is zero (L_vv = 0) and the third negative (L_vvv < 0), found
/// between pixels by linear interpolation; hysteresis over linked contours. Works on a small rectangle. Keeps
/// its buffers. Source: Canny, PAMI 8(6), 1986; Lindeberg, IJCV 30(2), 1998, section 4.
class EdgeDetector {
 public:
  explicit EdgeDetector(double sigma_px);

  [[nodiscard]] double sigma_px() const { return sigma_px_; }

  /// Edges inside `region`, which lies within the image. The result stays good until the next call.
  std::span<const EdgePoint> detect(const Brightness& image, const Region& region,
                                    const EdgeThresholds& thresholds);

 private:
  /// L_vv, L_vvv and the gradient at one pixel.
  struct Differential {
    float second = 0.0F;
    float third = 0.0F;
    float gx = 0.0F;
    float gy = 0.0F;
  };

  void smooth(const Brightness& image);
  void differentiate();
  void linkCell(int x, int y);
  int crossing(int x, int y, bool down);
  void keepStrong();
  int root(int point);
  void join(int a, int b);
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  double sigma_px_;
  std::vector<float> kernel_;  ///< one half of the Gaussian, centre first
  EdgeThresholds thresholds_;
  Region region_;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> rows_;      ///< smoothed along x
  std::vector<float> smoothed_;  ///< along y too
  std::vector<float> line_;
  std::vector<Differential> differential_;
  std::vector<int> crossings_;  ///< edge point on the step to the right and downwards of each pixel, or -1
  std::vector<EdgePoint> points_;
  std::vector<int> parents_;
  std::vector<char> strong_;
};

}  // namespace mirrorarm::vision
