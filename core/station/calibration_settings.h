#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "core/calibration/capture_rule.h"
#include "core/calibration/drift_check.h"
#include "core/common/time.h"
#include "core/control/supervisor.h"
#include "core/robot/planner.h"

namespace mirrorarm::station {

/// How a calibration works. Defaults are the paper's where it names a figure.
struct CalibrationSettings {
  std::filesystem::path
      folder{};  ///< of the calibrations; empty: nothing is in force, nothing can be accepted
  std::filesystem::path black_box_folder{};  ///< where a stop leaves its last seconds; empty: nowhere

  /// Towards the rim of a wide lens only a part of a plate sends enough light back.
  calibration::CaptureSettings capture{.least_share = 0.3};
  calibration::DriftLimits drift_limits{};
  control::SupervisorSettings supervisor{};
  robot::PlannerSettings planner{};
  std::string limits_profile = "therapy";
  double table_height_m = 0.0;  ///< the robot's base stands on it: its top in B

  std::size_t stereo_views = 30;
  std::size_t hand_eye_stations = 15;
  /// Stations of the robot's grid for a drift check along x, y and z of B: the paper's cuboid of 60 x 60 x
  /// 40 mm.
  Eigen::Vector3i drift_stations{4, 4, 3};
  double drift_step_m = 0.020;
  Seconds clock_motion{10.0};    ///< of movement before the board that the clock job wants
  double clock_turn_rad = 0.10;  ///< how far the camera turns to either side meanwhile
};

}  // namespace mirrorarm::station
