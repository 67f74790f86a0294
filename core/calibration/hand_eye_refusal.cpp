#include "core/calibration/hand_eye_refusal.h"

namespace mirrorarm::calibration {
namespace {

std::string listed(const std::vector<std::size_t>& stations) {
  std::string text;
  for (const auto station : stations) text += (text.empty() ? "" : ", ") + std::to_string(station);
  return text;
}

}  // namespace

std::string reason(HandEyeError error) {
  switch (error) {
    case HandEyeError::kTooFewPairs:
      return "holds fewer than 3 pose pairs: capture at least 3 stations, better 15";
    case HandEyeError::kNotRigid:
      return "a pose is not finite or its rotation is none";
    case HandEyeError::kRobotInMillimetres:
      return "the robot's positions are beyond 20 m: they look like millimetres, give metres";
    case HandEyeError::kCameraInMillimetres:
      return "the camera's positions are beyond 20 m: they look like millimetres, give metres";
    case HandEyeError::kTurnsTooSmall:
      return "the flange turned by less than 8 degrees between any two stations: turn it by 30 and more "
             "about two axes";
    case HandEyeError::kOneAxis:
      return "the flange turned about one axis only: capture stations turned about a second axis as well";
    case HandEyeError::kRobotInverted:
      return "the robot's poses look inverted: give the flange in the base (X_BF), not the base in the "
             "flange";
    case HandEyeError::kCameraInverted:
      return "the camera's poses look inverted: give the board in the camera (X_CM), not the camera in the "
             "board; or camera and board have changed places: say the other --eye";
    case HandEyeError::kBothInverted:
      return "the robot's and the camera's poses both look inverted: give the flange in the base (X_BF) and "
             "the board in the camera (X_CM); or only the robot's are, and --eye is the other one";
    case HandEyeError::kCameraBesideRobot:
      return "the camera stands beside the robot and the board is on the flange: say --eye to-hand";
    case HandEyeError::kCameraInHand:
      return "the camera is on the flange and the board stands beside the robot: say --eye in-hand";
    case HandEyeError::kRobotScalarFirst:
      return "the robot's quaternions look written w, x, y, z: write x, y, z, w";
    case HandEyeError::kCameraScalarFirst:
      return "the camera's quaternions look written w, x, y, z: write x, y, z, w";
    case HandEyeError::kBothScalarFirst:
      return "the quaternions look written w, x, y, z: write x, y, z, w";
    case HandEyeError::kBoardTurned:
      return "the board is seen half a turn round at some stations, and at too few others to tell its size: "
             "use a board whose ends differ (an odd and an even number of squares), or capture again";
    case HandEyeError::kNotSolved:
      return "the turns do not fix the camera: capture stations turned by 20 to 60 degrees about two axes";
    case HandEyeError::kInconsistent:
      break;
  }
  return "robot and camera contradict each other: check that each robot pose belongs to its image, that the "
         "board and its mount did not move, and that all poses are in metres";
}

std::string reason(const HandEyeRefusal& refusal) {
  if (refusal.stations.empty()) return reason(refusal.error);
  return reason(refusal.error) + "; stations " + listed(refusal.stations) + ", counted from 0";
}

}  // namespace mirrorarm::calibration
