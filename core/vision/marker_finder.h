#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>

#include "core/camera/camera_model.h"
#include "core/camera/image.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// What the finder takes for a disc. Defaults suit the bench: 7 mm discs at 0.25 to 0.8 m, f about 550 to 720 px.
struct FinderSettings {
  double min_diameter_px = 4.0;
  double max_diameter_px = 60.0;
  double max_axis_ratio = 4.0;        ///< major to minor axis
  double max_fit_rms_px = 0.35;       ///< edge points from the fitted ellipse
  double min_outline_fraction = 0.6;  ///< share of the outline that edge points must support
  double edge_sigma_px = 1.0;         ///< scale of the edge detector
  bool dark_on_bright = false;        ///< calibration plates: dark dots on bright ground
};

/// A rectangle of raw pixels to look at, both ends included.
struct Region {
  int left = 0, top = 0, right = -1, bottom = -1;
};

/// Finds discs in one raw image with sub-pixel centres: search by brightness against the image's own background,
/// a region of interest around each candidate, Canny's steps with Lindeberg's differential non-maximum
/// suppression, Fitzgibbon's ellipse fit on points undistorted by the lens model (no image is resampled).
/// One finder a camera and thread: it keeps its buffers from frame to frame.
/// Source: paper section 2.2; Lindeberg, IJCV 30(2), 1998; Fitzgibbon, Pilu, Fisher, PAMI 21(5), 1999.
class MarkerFinder {
 public:
  /// Without a camera the fit happens in raw pixels: plain images need no rig.
  explicit MarkerFinder(const FinderSettings& settings, std::optional<camera::CameraModel> camera = {});
  ~MarkerFinder();
  MarkerFinder(MarkerFinder&&) noexcept;
  MarkerFinder& operator=(MarkerFinder&&) noexcept;

  /// Searches the whole image, or only `regions` when there are any. Never throws for what an image holds:
  /// black, white, noise, 1x1 give an empty result.
  [[nodiscard]] Detection find(const camera::ImageView& image, std::span<const Region> regions = {});

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::vision
