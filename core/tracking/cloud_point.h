#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking {

/// The discs of both images that a cloud point was measured from, -1 where that is not known: of points that
/// share a disc at most one is real.
struct SeenDiscs {
  int left = -1;
  int right = -1;
};

[[nodiscard]] inline bool shareADisc(const SeenDiscs& a, const SeenDiscs& b) {
  return (a.left >= 0 && a.left == b.left) || (a.right >= 0 && a.right == b.right);
}

/// A measured point as registration sees it.
struct CloudPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();            ///< in the left camera [m]; finite
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();  ///< of the sensor; zero when not known
  SeenDiscs discs;
};

/// A stereo point as registration sees it.
[[nodiscard]] CloudPoint cloudPointOf(const vision::StereoPoint& point);
/// All points that are finite, rivals too; `cloud` is emptied first.
void collectCloud(std::span<const vision::StereoPoint> points, std::vector<CloudPoint>& cloud);

}  // namespace mirrorarm::tracking
