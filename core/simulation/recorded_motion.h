#pragma once

#include <array>
#include <vector>

#include "core/common/file_error.h"
#include "core/simulation/arm_motion.h"
#include "core/simulation/trc_file.h"

namespace mirrorarm::simulation {

/// A real arm's recorded movement, skin deformation included, played to and fro with half a pass's speed
/// ramped at the turning points; positions between samples by Catmull-Rom splines.
///
/// The ten forearm markers of the recording (epicondyles, forearm, styloids, wrist) carry the discs. One
/// rigid motion places the whole recording so that at its start the forearm has the pose asked: middle
/// between elbow and wrist at the origin of A, x_A to the wrist, and the side that carries the markers
/// towards z_A. A recording gives no normals. At the start each disc looks to the cameras, turned at most 35
/// degrees towards the outward direction of its place on the forearm; from then on it turns with the best
/// rigid fit of all ten.
class RecordedMotion final : public ArmMotion {
 public:
  using CameraPositions = std::array<Eigen::Vector3d, 2>;

  /// `X_BA` is where the forearm starts, `cameras_B` where the two cameras are then.
  /// Refused: see readTrc(); markers that do not fix a pose.
  [[nodiscard]] static FromFile<RecordedMotion> read(const std::filesystem::path& file,
                                                     const RigidTransform& X_BA,
                                                     const CameraPositions& cameras_B);

  [[nodiscard]] int discCount() const override;
  void discsAt(double phase_s, std::span<Disc> discs) const override;
  [[nodiscard]] Forearm forearmAt(double phase_s) const override;

 private:
  RecordedMotion(MarkerMotion motion_B, const CameraPositions& cameras_B);
  [[nodiscard]] std::vector<Eigen::Vector3d> markersAt(double phase_s) const;

  MarkerMotion motion_B_;
  std::vector<Eigen::Vector3d> start_normals_B_;
};

}  // namespace mirrorarm::simulation
