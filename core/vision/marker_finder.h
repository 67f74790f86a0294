#pragma once

#include <memory>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/camera/camera_model.h"
#include "core/camera/image.h"
#include "core/vision/detected_marker.h"
#include "core/vision/finder_settings.h"
#include "core/vision/region.h"

namespace mirrorarm::vision {

/// Finds discs in one raw image with sub-pixel centres: search by brightness against the image's own
/// background, a region of interest around each candidate, Canny's steps with Lindeberg's differential
/// non-maximum suppression, Fitzgibbon's ellipse fit on points undistorted by the lens model (no image is
/// resampled). One finder a camera and thread: it keeps its buffers from frame to frame. Source: paper
/// section 2.2; Lindeberg, IJCV 30(2), 1998; Fitzgibbon, Pilu, Fisher, PAMI 21(5), 1999.
class MarkerFinder {
 public:
  /// Without a camera the fit happens in raw pixels: plain images need no rig.
  explicit MarkerFinder(const FinderSettings& settings, std::optional<camera::CameraModel> camera = {});
  ~MarkerFinder();
  MarkerFinder(MarkerFinder&&) noexcept;
  MarkerFinder& operator=(MarkerFinder&&) noexcept;

  /// Searches the whole image, or only `regions` when there are any. Never throws for what an image holds:
  /// black, white, noise, 1x1 give an empty result. The answer stays good until the next call; nothing is
  /// taken from the heap once the buffers have grown.
  [[nodiscard]] const Detection& find(const camera::ImageView& image, std::span<const Region> regions = {});

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::vision
