#pragma once

#include <span>

#include <Eigen/Core>

#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

/// What the disparity gradient needs of a pair, in rectified pixels (paper equation 10).
struct RectifiedPair {
  Eigen::Vector2d cyclopean_px = Eigen::Vector2d::Zero();
  double disparity_px = 0.0;
  double misfit = 0.0;  ///< how ill the pair agrees with one disc: decides between equal support
};

/// Fills support, rivals and preferred of all points; `pairs` has one entry a point. A pair is supported by
/// every other that claims neither of its discs and whose disparity gradient with it is within the limit, by
/// their reciprocal distance in the cyclopean image (paper equation 11).
void fillSupport(std::span<const RectifiedPair> pairs, double max_disparity_gradient,
                 std::span<StereoPoint> points);

}  // namespace mirrorarm::vision
