#pragma once

#include <span>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// A left image and the right image that was taken with it, by the numbers of their views.
struct ImagePair {
  std::size_t left = 0;
  std::size_t right = 0;
  bool operator==(const ImagePair&) const = default;
};

/// What two cameras on one bar say of the bar: the board stood in both at once.
struct BarVote {
  RigidTransform X_RC =
      RigidTransform::Identity();  ///< of the views as they are paired, the one nearest to all
  std::vector<ImagePair> better;   ///< pairs across views; empty where the views are paired rightly
};

/// `X_LM`, `X_RM`: the board in the left and in the right camera, a view each, each camera calibrated for
/// itself. Where many views disagree on the bar, all pairs of a left and a right view are tried: if some bar
/// brings more of them together than any bar does as they are paired, those that are not of one view are
/// named. At least one view.
[[nodiscard]] BarVote voteForBar(std::span<const RigidTransform> X_LM, std::span<const RigidTransform> X_RM);

}  // namespace mirrorarm::calibration
