#pragma once

#include <span>
#include <vector>

#include "core/camera/camera_model.h"
#include "core/common/expected.h"
#include "core/vision/detected_marker.h"
#include "core/vision/edge_detector.h"
#include "core/vision/ellipse_fit.h"
#include "core/vision/finder_settings.h"
#include "core/vision/fit_plane.h"

namespace mirrorarm::vision {

/// From a disc's outline to the marker: edge points undistorted by the lens model, ellipse fitted, centre
/// carried back into the raw image with its covariance. Keeps its buffers.
class DiscFit {
 public:
  explicit DiscFit(const FinderSettings& settings) : settings_(settings) {}

  /// `noise` is the image's standard deviation [grey], `sigma_px` the scale of the edges; `camera` may be
  /// null: then raw pixels are fitted.
  [[nodiscard]] Expected<DetectedMarker, Rejection> fit(std::span<const EdgePoint> outline,
                                                        const camera::CameraModel* camera, double noise,
                                                        double sigma_px);

 private:
  /// False where a point lies outside the lens model.
  [[nodiscard]] bool carryTo(const FitPlane& plane, std::span<const EdgePoint> outline);
  [[nodiscard]] double supportedShare(const EllipseMap& ellipse, double length_px) const;

  FinderSettings settings_;
  EllipseRefiner refiner_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<char> supports_;
};

}  // namespace mirrorarm::vision
