#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/camera/stereo_rig.h"
#include "core/common/expected.h"
#include "core/simulation/scene.h"
#include "core/simulation/scene_player.h"
#include "core/tracking/teacher.h"
#include "core/tracking/tracker.h"
#include "core/vision/finder_settings.h"

namespace mirrorarm::experiments {

/// How images become poses.
struct Approach {
  vision::CentreMethod centres = vision::FinderSettings{}.method;
  tracking::TrackingMethod tracking = tracking::TrackingMethod::kCliques;
};
/// The paper's own: Lindeberg's edges, Fitzgibbon's ellipses, softassign.
inline constexpr Approach kPaperApproach{vision::CentreMethod::kLindebergFitzgibbon,
                                         tracking::TrackingMethod::kSoftassign};

/// A scene played once and kept: what the cameras saw and the truth.
struct PlayedScene {
  camera::StereoRig rig;
  std::vector<Eigen::Vector3d> markers_T;
  std::vector<simulation::ScenePlayer::Shot> shots;
};
[[nodiscard]] FromFile<PlayedScene> play(const simulation::Scene& scene,
                                         const std::filesystem::path& resources);

/// One frame of it as it was tracked.
struct TrialFrame {
  tracking::TrackedTarget answer;
  RigidTransform X_CT = RigidTransform::Identity();  ///< truth, of the scene's own frame T
  double vision_ms = 0.0;
  double tracking_ms = 0.0;
};

/// The target as the product learns it from these images; the error is the teacher's.
[[nodiscard]] Expected<tracking::Target, tracking::TeachingError> teachFrom(const PlayedScene& scene,
                                                                            vision::CentreMethod centres);

/// Finds and follows `target` through the scene, from nothing on. With `look_ahead` the images are searched
/// only where the tracker expects the markers, as in a session.
[[nodiscard]] std::vector<TrialFrame> track(const PlayedScene& scene, const tracking::Target& target,
                                            const Approach& approach, bool look_ahead);

}  // namespace mirrorarm::experiments
