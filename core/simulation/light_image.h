#pragma once

#include <span>
#include <vector>

#include "core/camera/camera_model.h"
#include "core/simulation/patch.h"
#include "core/simulation/point_spread.h"

namespace mirrorarm::simulation {

/// Pixels x in [left, right), y in [top, bottom).
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
};

/// The light that falls on a sensor, before noise; kept from frame to frame and cleared only where it was
/// lit.
///
/// A patch is rendered exactly through the lens: by Green's theorem the light in a pixel is an integral
/// around the patch's projected outline, whose integrand is smooth once the point spread is in it, so that
/// even steps of 0.75 pixels integrate it to 1e-8. No supersampling, no pinhole or ellipse
/// approximation.
class LightImage {
 public:
  LightImage(const camera::CameraModel& camera, double spread_sigma_px);

  /// Adds a patch given in the camera's frame, `level` of light in each pixel it fills. Nothing happens when
  /// any of its outline lies outside the range of the lens model.
  void add(const Patch& patch_C, double level);

  [[nodiscard]] std::span<const PixelBox> lit() const { return lit_; }
  [[nodiscard]] const float* row(int y) const {
    return light_.data() + static_cast<std::ptrdiff_t>(y) * width_;
  }
  void clear();

 private:
  struct Step {
    double x = 0.0, y = 0.0, dy = 0.0;
  };
  [[nodiscard]] bool traceOutline(const Patch& patch_C);
  [[nodiscard]] bool project(const Patch& patch_C, int count);
  [[nodiscard]] PixelBox boxOfOutline() const;
  void addStep(const Step& step, const PixelBox& box, float level);

  camera::CameraModel camera_;
  PointSpread spread_;
  int width_ = 0, height_ = 0;
  std::vector<float> light_;
  std::vector<PixelBox> lit_;
  std::vector<Step> outline_;  ///< work space
  std::vector<float> edge_;    ///< work space
};

}  // namespace mirrorarm::simulation
