#pragma once

#include <vector>

#include "benchmarks/trial_random.h"
#include "benchmarks/vision/stereo_discs.h"
#include "core/tracking/pose_estimator.h"

namespace mirrorarm::benchmarks::tracking {

/// A target of ten 7 mm discs around a forearm: on 130 degrees of a cylinder of 45 mm radius and 150 mm
/// length around x, seen along z. Centres in T, whose origin is their centroid.
[[nodiscard]] std::vector<vision::StereoDisc> forearmDiscs_T();

/// The target with the cylinder's axis 400 mm before the middle between the cameras, turned by up to 15
/// degrees.
[[nodiscard]] RigidTransform forearmPose(TrialRandom& random);

/// The discs at X_CT with their projections through the rig.
[[nodiscard]] std::vector<vision::StereoDisc> discsAt(const camera::StereoRig& rig,
                                                      const std::vector<vision::StereoDisc>& discs_T,
                                                      const RigidTransform& X_CT);

/// What a detector with white noise of `sigma_px` on each centre makes of the discs: triangulated, with their
/// covariances. The models are the true ones.
[[nodiscard]] std::vector<mirrorarm::tracking::MarkerMatch> measuredMatches(
    const camera::StereoRig& rig, const std::vector<vision::StereoDisc>& discs_T,
    const std::vector<vision::StereoDisc>& discs_C, double sigma_px, TrialRandom& random);

}  // namespace mirrorarm::benchmarks::tracking
