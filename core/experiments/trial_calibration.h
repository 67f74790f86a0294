#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/calibration/hand_eye.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/stereo_rig.h"
#include "core/common/expected.h"

namespace mirrorarm::experiments {

struct TrialCalibrationSettings {
  int views = 30;     ///< image pairs of the plate for the rig
  int stations = 15;  ///< standstills of the robot for the hand-eye calibration
  std::uint64_t seed = 1;
};

/// A rig as the product makes it, from simulated images alone.
struct RigTrial {
  camera::StereoRig true_rig;
  calibration::Board plate;
  std::vector<calibration::BoardView> views;
  calibration::StereoCalibration stereo;
};

/// A rig and then a hand-eye calibration.
struct TrialCalibration {
  RigTrial rig;
  RigidTransform true_X_FC = RigidTransform::Identity();
  calibration::HandEyeSolution hand_eye;

  /// Of the camera's place on the flange.
  [[nodiscard]] double handEyeError_mm() const;
};

/// The bench's fisheye rig and a dot plate of 9 by 7 dots, 30 mm apart, in the views that the next-view rule
/// proposes. The error says what could not be read or solved.
[[nodiscard]] Expected<RigTrial, std::string> calibrateRigInSimulation(
    const std::filesystem::path& resources, const TrialCalibrationSettings& settings);

/// The same, and with that rig the hand-eye calibration: the LBR 4+ carries the cameras over the plate on a
/// table, its angles read with the encoders' noise.
[[nodiscard]] Expected<TrialCalibration, std::string> calibrateInSimulation(
    const std::filesystem::path& resources, const TrialCalibrationSettings& settings);

}  // namespace mirrorarm::experiments
