#pragma once

#include <CLI/App.hpp>

#include "app/cli/command.h"
#include "core/calibration/board_images.h"
#include "core/calibration/camera_calibration.h"

namespace mirrorarm::cli {

/// The commands under `calibrate`.
void addCalibrateHandEye(CLI::App& calibrate, Context& context);
void addCalibrateMono(CLI::App& calibrate, Context& context);
void addCalibrateStereo(CLI::App& calibrate, Context& context);

/// What the lens calibrations have in common on the command line.
struct LensWish {
  std::string board;
  std::string model;
  std::string out;
};
void addLensOptions(CLI::App& command, LensWish& wish);

/// The wished board, or InputRefused.
[[nodiscard]] calibration::Board wishedBoard(const LensWish& wish);
/// The wished model; the options let no other name through.
[[nodiscard]] camera::LensModel wishedModel(const LensWish& wish);

/// Throws the refusal of `images` for `error`, with the images where the board was not found.
[[noreturn]] void refuseViews(const std::string& images, calibration::CalibrationError error,
                              const calibration::BoardImages& read);

/// Tells a person which views were not used.
void tellLeftOut(const std::vector<std::string>& outliers, const calibration::BoardImages& read);

}  // namespace mirrorarm::cli
