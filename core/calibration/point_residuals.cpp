#include "core/calibration/point_residuals.h"

#include "core/calibration/board_pose.h"

namespace mirrorarm::calibration {

std::vector<PointResidual> pointResiduals(const camera::StereoRig& rig, const Board& board,
                                          std::span<const BoardView> views) {
  const auto points = boardPoints(board);
  std::vector<PointResidual> residuals;
  for (const auto& view : views) {
    const auto pose = poseBoard(rig, board, view);
    if (!pose) continue;
    for (std::size_t k = 0; k < pose->centres.seen.size(); ++k)
      for (const auto& seen : pose->centres.seen[k]) {
        const Eigen::Vector3d p_C = pose->X_CM * points[static_cast<std::size_t>(seen.point)];
        const auto pixel = k == 0 ? rig.left.project(p_C) : rig.right.project(rig.X_RC * p_C);
        if (pixel) residuals.push_back({view.name, static_cast<int>(k), seen.point, seen.pixel - *pixel});
      }
  }
  return residuals;
}

}  // namespace mirrorarm::calibration
