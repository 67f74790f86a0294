#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// How far one point of one image lies from where a rig puts it.
struct PointResidual {
  std::string view;                                     ///< name of the view
  int camera = 0;                                       ///< 0 the left, 1 the right
  int point = 0;                                        ///< index into boardPoints()
  Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();  ///< seen minus projected, disc centres freed of bias
};

/// Of every point, the board posed from its own view alone. A view in which it cannot be posed is passed
/// over, and so are points outside a lens model's range.
[[nodiscard]] std::vector<PointResidual> pointResiduals(const camera::StereoRig& rig, const Board& board,
                                                        std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
