#include "core/control/gaze.h"

#include <algorithm>
#include <array>
#include <limits>

namespace mirrorarm::control {
namespace {

constexpr double kLeastMargin_px = 15.0;
constexpr int kHalvings = 8;

double marginOf(const camera::CameraModel& camera, const Eigen::Vector3d& p) {
  const auto pixel = camera.project(p);
  if (!pixel) return -std::numeric_limits<double>::infinity();
  const double right = camera.intrinsics().width_px - 1.0 - pixel->x();
  const double below = camera.intrinsics().height_px - 1.0 - pixel->y();
  return std::min({pixel->x(), pixel->y(), right, below});
}

ToolGoal partOf(const ToolGoal& goal, const RigidTransform& X_BE_now, double share) {
  return {interpolate(X_BE_now, goal.X_BE, share), interpolate(X_BE_now, goal.X_BE_soon, share), goal.soon};
}

}  // namespace

Gaze::Gaze(const camera::StereoRig& rig, const RigidTransform& X_EC) : rig_(rig), X_CE_(X_EC.inverse()) {}

double Gaze::margin_px(const RigidTransform& X_BE, const Sight& sight) const {
  const Eigen::Vector3d centre_C = X_CE_ * (X_BE.inverse() * sight.centre_B);
  const double r = sight.radius_m;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& aside : {Eigen::Vector3d(-r, 0, 0), Eigen::Vector3d(r, 0, 0),
                                       Eigen::Vector3d(0, -r, 0), Eigen::Vector3d(0, r, 0)}) {
    const Eigen::Vector3d p_C = centre_C + aside;
    least = std::min({least, marginOf(rig_.left, p_C), marginOf(rig_.right, rig_.X_RC * p_C)});
  }
  return least;
}

bool Gaze::sees(const RigidTransform& X_BE, const Sight& sight) const {
  return margin_px(X_BE, sight) >= kLeastMargin_px;
}

Gaze::Kept Gaze::keep(const ToolGoal& goal, const RigidTransform& X_BE_now, const Sight& sight) const {
  const double there = margin_px(goal.X_BE, sight);
  if (there >= kLeastMargin_px) return {goal, false};
  const double here = margin_px(X_BE_now, sight);
  if (here < kLeastMargin_px)
    return there > here ? Kept{goal, false} : Kept{ToolGoal::resting(X_BE_now), true};
  double seen = 0.0, lost = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (seen + lost);
    (sees(interpolate(X_BE_now, goal.X_BE, middle), sight) ? seen : lost) = middle;
  }
  return {partOf(goal, X_BE_now, seen), true};
}

}  // namespace mirrorarm::control
