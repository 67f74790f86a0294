#include "core/tracking/followed_target.h"

#include <algorithm>

#include "core/camera/stereo_view.h"

namespace mirrorarm::tracking {

FollowedTarget::FollowedTarget(const Target& taught, const SkinSettings& settings)
    : settings_(settings), skin_(taught, settings) {}

void FollowedTarget::begin(TimePoint time) {
  skin_.predict(time);
  event_ = SkinEvent::kNone;
  point_of_marker_.assign(skin_.shape_T().size(), -1);
}

Shape FollowedTarget::shape() const { return {skin_.shape_T(), skin_.covariance_m2(), skin_.present()}; }

std::span<const Eigen::Vector3d> FollowedTarget::placesAt(const RigidTransform& X_CT) {
  places_C_.clear();
  for (const auto& p_T : skin_.shape_T()) places_C_.push_back(X_CT * p_T);
  return places_C_;
}

bool FollowedTarget::isFresh(TimePoint time, Seconds for_how_long) const {
  return motion_.isKnown() && motion_.ageAt(time) <= for_how_long;
}

void FollowedTarget::accept(const ShapeFit& fit, TimePoint time, FrameCloud& cloud) {
  for (std::size_t j = 0; j < fit.point_of_marker.size(); ++j)
    point_of_marker_[j] = fit.point_of_marker[j] < 0 ? -1 : cloud.pointOf(fit.point_of_marker[j]);
  for (const int point : point_of_marker_)
    if (point >= 0) cloud.take(point);
  last_X_CT_ = fit.pose.X_CT;
  motion_.add(time, {fit.pose.X_CT, fit.pose.covariance});
}

void FollowedTarget::learn(TimePoint time, const FrameCloud& cloud,
                           const std::optional<camera::StereoRig>& rig) {
  const SkinEvent event = skin_.observe(observation(time, last_X_CT_, cloud, rig));
  if (event != SkinEvent::kNone) event_ = event;
}

bool FollowedTarget::learnFromMisfit(TimePoint time, const FrameCloud& cloud,
                                     const std::optional<camera::StereoRig>& rig) {
  event_ = skin_.observeMisfit(observation(time, motion_.at(time).X_CT, cloud, rig));
  point_of_marker_.assign(skin_.shape_T().size(), -1);
  if (!skin_.foundPose()) return false;
  motion_.moveTo(time, *skin_.foundPose());
  return true;
}

SkinObservation FollowedTarget::observation(TimePoint time, const RigidTransform& X_CT,
                                            const FrameCloud& cloud,
                                            const std::optional<camera::StereoRig>& rig) {
  in_view_.clear();
  for (const auto& place_C : placesAt(X_CT))
    in_view_.push_back(!rig || camera::bothCamerasSee(*rig, place_C) ? 1 : 0);
  return {time, X_CT, cloud.points(), point_of_marker_, cloud.taken(), in_view_};
}

void FollowedTarget::replaceShape(const Target& target) {
  replaced_ += skin_.version() + 1;
  skin_ = SkinModel(target, settings_);
  point_of_marker_.assign(skin_.shape_T().size(), -1);
}

bool FollowedTarget::isOutOfView(TimePoint time, const camera::StereoRig& rig) {
  if (!motion_.isKnown()) return false;
  const auto places_C = placesAt(motion_.at(time).X_CT);
  const auto seen = std::count_if(places_C.begin(), places_C.end(), [&rig](const auto& place_C) {
    return camera::bothCamerasSee(rig, place_C);
  });
  return seen < 3;
}

}  // namespace mirrorarm::tracking
