#pragma once

#include <memory>

#include "core/common/expected.h"
#include "core/vision/brightness.h"
#include "core/vision/component_scanner.h"
#include "core/vision/detected_marker.h"
#include "core/vision/finder_settings.h"

namespace mirrorarm::camera {
class CameraModel;
}

namespace mirrorarm::vision {

/// A light that may be a disc, and what it stands on.
struct Light {
  Component component;
  double ground = 0.0;  ///< [grey]
  double noise = 1.0;   ///< standard deviation in the ground [grey]

  [[nodiscard]] Eigen::Vector2d middle_px() const { return {component.x(), component.y()}; }
  [[nodiscard]] double height() const { return component.peak - ground; }
};

/// One way to measure a disc. Keeps its buffers; one thread.
class DiscEstimator {
 public:
  virtual ~DiscEstimator() = default;

  /// The light as a whole disc. Refused with kCut when it may be a disc of which something covers a part.
  [[nodiscard]] virtual Expected<DetectedMarker, Rejection> measure(const Brightness& image,
                                                                    const Light& light) = 0;
  /// The light as a disc with a straight cover over a part; to be asked after measure() said kCut and the
  /// light does not fall apart into several.
  [[nodiscard]] virtual Expected<DetectedMarker, Rejection> measureCut(const Brightness&, const Light&) {
    return unexpected(Rejection::kCut);
  }
};

/// The estimator that the settings name. `camera` may be null and must outlive it.
[[nodiscard]] std::unique_ptr<DiscEstimator> makeDiscEstimator(const FinderSettings& settings,
                                                               const camera::CameraModel* camera);

/// The first of the settings' limits of size and form that a measured disc breaks.
[[nodiscard]] Expected<DetectedMarker, Rejection> withinLimits(const DetectedMarker& marker,
                                                               const FinderSettings& settings);

}  // namespace mirrorarm::vision
