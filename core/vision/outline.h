#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/vision/edge_detector.h"

namespace mirrorarm::vision {

/// Of all edge points around a candidate those of the one contour that best goes around `inside`, bright side
/// inwards: most sectors first, then the stronger gradient. `outline` is emptied and filled; it stays empty
/// when no contour goes even half around, or the best is on average less steep than `least_gradient`.
void selectOutline(std::span<const EdgePoint> edges, const Eigen::Vector2d& inside, float least_gradient,
                   std::vector<EdgePoint>& outline);

}  // namespace mirrorarm::vision
