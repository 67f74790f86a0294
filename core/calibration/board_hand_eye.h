#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/hand_eye.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// One standstill: what both cameras saw and where the robot said its flange was.
struct HandEyeStation {
  BoardView view;
  RigidTransform X_BF = RigidTransform::Identity();
};

/// How far a robot is from where it says, at one station, along each axis.
struct RobotNoise {
  double sigma_m = 1e-4;
  double sigma_rad = 0.02 * std::numbers::pi / 180.0;
};

/// Size of the board against what was said of it, told by the robot's steps.
struct BoardScale {
  double scale = 1.0;
  double sigma = 0.0;
  bool is_noticed = false;  ///< more than 3 sigma and 0.2 % from 1; only then the solution takes it up
};

struct BoardHandEye {
  HandEyeSolution hand_eye;  ///< stations counted as given; those without a board pose are outliers
  double rms_px = 0.0;       ///< distance of a point from its projection, over the stations used
  std::vector<std::optional<double>> stations_px;  ///< the same by station; nothing for those left out
  BoardScale board;
};

/// Hand-eye of greatest likelihood over the pixels: X_PC, X_QM, where the flange really was at each station
/// (held to its pose by `robot`), and the size of the board, from the projections of all points into both
/// cameras, robustly. Starts at solveHandEye() of the boards' poses, which finds the outliers and the boards
/// seen half a turn round. Discs are freed of their bias first. Refusals are those of solveHandEye.
[[nodiscard]] Expected<BoardHandEye, HandEyeRefusal> refineHandEye(const camera::StereoRig& rig,
                                                                   const Board& board,
                                                                   std::span<const HandEyeStation> stations,
                                                                   CameraMount mount,
                                                                   const RobotNoise& robot = {});

}  // namespace mirrorarm::calibration
