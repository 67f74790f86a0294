#include "core/tracking/cloud_point.h"

namespace mirrorarm::tracking {

CloudPoint cloudPointOf(const vision::StereoPoint& point) {
  return {point.p_C, point.covariance_m2, {point.left, point.right}};
}

void collectCloud(std::span<const vision::StereoPoint> points, std::vector<CloudPoint>& cloud) {
  cloud.clear();
  for (const vision::StereoPoint& point : points)
    if (point.p_C.allFinite() && point.covariance_m2.allFinite()) cloud.push_back(cloudPointOf(point));
}

}  // namespace mirrorarm::tracking
