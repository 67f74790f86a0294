#include "core/calibration/park_martin.h"

#include <vector>

#include "core/calibration/relative_motion.h"
#include "core/geometry/rigid_fit.h"

namespace mirrorarm::calibration {
namespace {

/// Turned both ways, so that the vectors have no mean and the fit is of the rotation alone.
Eigen::Matrix3d rotationOverMotions(std::span<const RelativeMotion> motions) {
  std::vector<Eigen::Vector3d> robot, camera;
  for (const auto& motion : motions)
    for (const double way : {1.0, -1.0}) {
      robot.push_back(way * rotationVector(motion.A.linear()));
      camera.push_back(way * rotationVector(motion.B.linear()));
    }
  return fitByKabsch(camera, robot).linear();
}

}  // namespace

std::optional<RigidTransform> parkMartin(std::span<const PosePair> pairs) {
  const auto motions = tellingMotions(pairs);
  if (motions.empty()) return std::nullopt;
  const Eigen::Matrix3d R_FC = rotationOverMotions(motions);
  const auto p_FC = positionOverMotions(motions, R_FC);
  if (!p_FC) return std::nullopt;
  return makeTransform(R_FC, *p_FC);
}

}  // namespace mirrorarm::calibration
