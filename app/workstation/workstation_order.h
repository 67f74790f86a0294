#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/robot_option/robot_option.h"
#include "core/station/calibration_command.h"

namespace mirrorarm::workstation {

/// How the workstation is opened on the simulated bench, whose hand another robot may carry.
struct WorkstationOrder {
  std::filesystem::path store;                       ///< records; empty: the user's own store
  std::filesystem::path calibrations;                ///< folder of the calibrations; empty: the user's own
  std::optional<station::CalibrationJob> calibrate;  ///< opens the wizards there instead of a session
  std::filesystem::path motion;  ///< a TRC file that moves the healthy arm; empty: `exercise`
  std::string exercise = "reach";
  std::uint64_t seed = 1;
  app::RobotOption robot;
  bool enabling_key = false;    ///< motion only while the enabling key is held
  bool help_as_needed = false;  ///< the robot gives way and adapts its help
  bool dark = false;
  std::array<int, 2> size_px{1600, 1000};  ///< width and height of the window
  std::filesystem::path tour;  ///< a folder: walk through what is opened and leave a picture of each step
  std::string language = "en";
};

/// Where the records are kept.
[[nodiscard]] std::filesystem::path storeOf(const WorkstationOrder& order);
/// Where the calibrations are kept; a tour has its own.
[[nodiscard]] std::filesystem::path calibrationsOf(const WorkstationOrder& order);

}  // namespace mirrorarm::workstation
