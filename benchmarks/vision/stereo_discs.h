#pragma once

#include <vector>

#include <Eigen/Core>

#include "benchmarks/trial_random.h"
#include "core/camera/stereo_rig.h"
#include "core/simulation/patch.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::benchmarks::vision {

/// A disc before both cameras, with its truth.
struct StereoDisc {
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_C = -Eigen::Vector3d::UnitZ();  ///< towards the cameras
  double radius_m = 0.0035;
  Eigen::Vector2d left_px = Eigen::Vector2d::Zero();   ///< projection of its centre
  Eigen::Vector2d right_px = Eigen::Vector2d::Zero();  ///< likewise

  [[nodiscard]] simulation::Patch patch_C() const;
};

struct DistanceRange {
  double least_m = 0.3;
  double most_m = 0.6;
};

/// The rig of the simulated bench, rigs/fisheye.yaml. Throws std::runtime_error when it cannot be read.
[[nodiscard]] camera::StereoRig fisheyeRig();

/// `count` discs of 7 mm anywhere in the field that both cameras share, at such distances from the left one,
/// tilted against both lines of sight by up to 60 degrees, at least `gap_px` between their centres in either
/// image. None is nearer to the cameras' plane than the matcher's own least depth.
[[nodiscard]] std::vector<StereoDisc> randomDiscs(const camera::StereoRig& rig, int count,
                                                  const DistanceRange& range, double gap_px,
                                                  TrialRandom& random);

/// The preferred point of the disc in what the product saw, or null: both its centres within 3 px of truth.
[[nodiscard]] const mirrorarm::vision::StereoPoint* pointOf(
    const StereoDisc& disc, const mirrorarm::vision::StereoObservation& observation);

}  // namespace mirrorarm::benchmarks::vision
