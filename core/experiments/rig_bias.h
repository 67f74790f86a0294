#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::experiments {

/// How far points lie from where they are, by a rig's own numbers alone: no noise.
struct RigBias {
  double rms_mm = 0.0;      ///< in the left camera's frame as calibrated
  double largest_mm = 0.0;  ///< the same, of the worst point
  /// After the best rigid motion of all points together: what no hand-eye calibration can take away.
  double shape_rms_mm = 0.0;
};

/// The stations of the paper's cuboid of 60 x 60 x 40 mm in steps of 20 mm, its middle 0.4 m before the
/// middle between both cameras.
[[nodiscard]] std::vector<Eigen::Vector3d> paperCuboid_C(const camera::StereoRig& rig);

/// `points_C` as `truth` images them, triangulated by `calibrated`. All of them are seen by both cameras.
[[nodiscard]] RigBias biasOf(const camera::StereoRig& calibrated, const camera::StereoRig& truth,
                             std::span<const Eigen::Vector3d> points_C);

}  // namespace mirrorarm::experiments
