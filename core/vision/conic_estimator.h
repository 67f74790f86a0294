#pragma once

#include <vector>

#include "core/vision/disc_estimator.h"

namespace mirrorarm::vision {

/// One linear solution without iteration: every pixel's gradient makes a line along the edge there; the dual
/// conic that all these lines touch, weighted by their gradients, is the outline. Source: Ouellet and Hebert,
/// Precise ellipse estimation without contour point extraction, Machine Vision and Applications 21(1), 2009.
class ConicEstimator final : public DiscEstimator {
 public:
  explicit ConicEstimator(const FinderSettings& settings) : settings_(settings) {}

  [[nodiscard]] Expected<DetectedMarker, Rejection> measure(const Brightness& image,
                                                            const Light& light) override;

 private:
  FinderSettings settings_;
};

}  // namespace mirrorarm::vision
