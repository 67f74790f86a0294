#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/pose_pairs.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// What a check at the start of the day says.
enum class DriftVerdict : std::uint8_t {
  kHolds,     ///< within the limits
  kDoubtful,  ///< between the limit and twice it: calibrate soon
  kFailed,    ///< calibrate before a session
};
/// "holds", "doubtful", "failed".
[[nodiscard]] std::string_view id(DriftVerdict verdict);
/// The verdict of that name, or nothing.
[[nodiscard]] std::optional<DriftVerdict> driftVerdictOf(std::string_view text);

/// Largest values with which a calibration holds.
struct DriftLimits {
  double epipolar_px = 0.15;
  double length_percent = 0.25;  ///< mean error of the board's lengths
  double grid_std_mm = 0.30;     ///< of the board's place along any axis, over the robot's grid
  double grid_scale_percent = 0.5;
};

/// The figures of one check; what was not measured is absent.
struct DriftFindings {
  double epipolar_px = 0.0;      ///< rms over both cameras, the discs freed of their bias
  double reprojection_px = 0.0;  ///< rms with the board posed from both images
  double length_percent = 0.0;   ///< mean error of the lengths between neighbouring points
  std::size_t points = 0;
  struct Grid {
    Eigen::Vector3d std_mm = Eigen::Vector3d::Zero();  ///< of the board's origin in the base, by axis
    double scale_percent = 0.0;                        ///< steps measured by the camera against the robot's
    std::size_t stations = 0;
  };
  std::optional<Grid> grid;
  DriftVerdict verdict = DriftVerdict::kFailed;
};

/// From one view or more of a board, and, where the robot moved between them, its poses: `X_BF` is empty or
/// as long as `views`. The grid wants 3 stations or more, 5 mm apart or farther. A camera that was pushed
/// aside on the flange without turning shows in `std_mm` only if the flange turns between the stations.
/// Source: the paper's grid of 20 mm steps (section 3.2). Nothing when no view shows enough of the board.
[[nodiscard]] std::optional<DriftFindings> checkDrift(const camera::StereoRig& rig,
                                                      const RigidTransform& X_FC, const Board& board,
                                                      std::span<const BoardView> views,
                                                      std::span<const RigidTransform> X_BF,
                                                      const DriftLimits& limits = {});

}  // namespace mirrorarm::calibration
