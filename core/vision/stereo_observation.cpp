#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

void collectPreferred(std::span<const StereoPoint> points, std::vector<Eigen::Vector3d>& places_C) {
  places_C.clear();
  for (const auto& point : points)
    if (point.preferred) places_C.push_back(point.p_C);
}

}  // namespace mirrorarm::vision
