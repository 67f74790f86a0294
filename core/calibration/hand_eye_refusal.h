#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mirrorarm::calibration {

/// Why stations give no hand-eye calibration: what the operator can mend.
enum class HandEyeError {
  kTooFewPairs,
  kNotRigid,
  kRobotInMillimetres,
  kCameraInMillimetres,
  kTurnsTooSmall,
  kOneAxis,
  kRobotInverted,      ///< X_FB was given for X_BF
  kCameraInverted,     ///< X_MC was given for X_CM
  kBothInverted,       ///< both of these
  kCameraBesideRobot,  ///< the camera was taken for one in the hand
  kCameraInHand,       ///< the camera was taken for one beside the robot
  kRobotScalarFirst,   ///< the robot's quaternions were written w, x, y, z
  kCameraScalarFirst,
  kBothScalarFirst,
  kBoardTurned,  ///< stations show the board half a turn round, and too few show it right to undo it
  kNotSolved,
  kInconsistent,
};

struct HandEyeRefusal {
  HandEyeError error = HandEyeError::kInconsistent;
  std::vector<std::size_t> stations;  ///< those it is about, counted from 0; empty for all
};

/// One line for an engineer: what is wrong, at which stations, and the remedy.
[[nodiscard]] std::string reason(HandEyeError error);
[[nodiscard]] std::string reason(const HandEyeRefusal& refusal);

}  // namespace mirrorarm::calibration
