#pragma once

#include <vector>

#include "core/tracking/pose_estimator.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {

/// How a shape lies in a cloud.
struct ShapeFit {
  LostReason reason = LostReason::kNoPoints;  ///< kNone when the fit was accepted
  std::vector<int> point_of_marker;  ///< index into the cloud, -1 for none; one-to-one, also in discs
  int matched = 0;
  PoseEstimate pose;  ///< good when accepted

  [[nodiscard]] bool isAccepted() const { return reason == LostReason::kNone; }
};

}  // namespace mirrorarm::tracking
