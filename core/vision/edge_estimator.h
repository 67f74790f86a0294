#pragma once

#include <vector>

#include "core/vision/disc_estimator.h"
#include "core/vision/disc_fit.h"
#include "core/vision/edge_detector.h"

namespace mirrorarm::vision {

/// The paper's measurement: Canny's steps with Lindeberg's differential non-maximum suppression around the
/// light, its outline's points undistorted by the lens model, Fitzgibbon's direct ellipse fit and a robust
/// refinement. Source: paper section 2.2.1.
class EdgeEstimator final : public DiscEstimator {
 public:
  EdgeEstimator(const FinderSettings& settings, const camera::CameraModel* camera);

  [[nodiscard]] Expected<DetectedMarker, Rejection> measure(const Brightness& image,
                                                            const Light& light) override;

 private:
  [[nodiscard]] Expected<DetectedMarker, Rejection> measureAt(const Brightness& image, const Light& light,
                                                              EdgeDetector& edges);

  const camera::CameraModel* camera_;
  EdgeDetector fine_;
  EdgeDetector coarse_;  ///< for large discs: their outline averages over more pixels at no loss
  DiscFit disc_;
  std::vector<EdgePoint> outline_;
};

}  // namespace mirrorarm::vision
