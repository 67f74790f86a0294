#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// What one view of a board tells about a rig's numbers, before it is taken: fx fy cx cy and two or four
/// distortion terms of each camera, then turn and shift of the bar.
class RigInformation {
 public:
  /// `board`: points of M; few and well spread are enough.
  RigInformation(const camera::StereoRig& rig, std::span<const Eigen::Vector3d> board);

  /// What a data sheet tells, so that the first view has something to add to.
  [[nodiscard]] Eigen::MatrixXd prior() const;
  /// Information matrix, the view's own pose eliminated; of the points that both cameras see.
  [[nodiscard]] Eigen::MatrixXd of(const RigidTransform& X_CM) const;

 private:
  camera::StereoRig rig_;
  std::vector<Eigen::Vector3d> board_;
};

/// The same for the camera on the flange and a board that stands still: of small motions of C and of M.
struct HandEyeInformation {
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  [[nodiscard]] static Matrix12 prior();
  [[nodiscard]] static Matrix12 of(const RigidTransform& X_CM);
};

}  // namespace mirrorarm::calibration
