#pragma once

#include <optional>

#include <CLI/App.hpp>

#include "app/cli/command.h"
#include "core/calibration/board_images.h"
#include "core/calibration/calibration_figures.h"
#include "core/calibration/calibration_refusal.h"

namespace mirrorarm::cli {

/// The commands under `calibrate`.
void addCalibrateClock(CLI::App& calibrate, Context& context);
void addCalibrateHandEye(CLI::App& calibrate, Context& context);
void addCalibrateMono(CLI::App& calibrate, Context& context);
void addCalibrateStereo(CLI::App& calibrate, Context& context);

/// What the lens calibrations have in common on the command line.
struct LensWish {
  std::string board;
  std::string model;  ///< empty: chosen by the error on views kept out
  std::string out;
};
void addLensOptions(CLI::App& command, LensWish& wish, const std::string& out_file);

/// The wished board, or InputRefused.
[[nodiscard]] calibration::Board wishedBoard(const LensWish& wish);
/// The wished model; the options let no other name through.
[[nodiscard]] std::optional<camera::LensModel> wishedModel(const LensWish& wish);

/// "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string>& names);

/// Throws the refusal of `images`, with the images where the board was not found.
[[noreturn]] void refuseViews(const std::string& images, const calibration::CalibrationRefusal& refusal,
                              const calibration::BoardImages& read);

/// What both lens calibrations give.
struct LensReport {
  double rms_px;
  camera::LensModel model;
  std::size_t views;
  const std::vector<std::string>& outliers;
  const calibration::HoldOut& hold_out;
  const std::vector<calibration::ViewResidual>& residuals;
  const std::optional<calibration::BoardShape>& board_shape;
  const std::vector<calibration::ModelTrial>& trials;
};
void fillLensReport(const LensReport& report, const calibration::BoardImages& read, Context& context);
[[nodiscard]] nlohmann::ordered_json toJson(const camera::LensSigma& sigma);
/// The lines of LensReport for a person, views that were not used last.
void tellLensReport(const LensReport& report, const calibration::BoardImages& read, const std::string& out);

}  // namespace mirrorarm::cli
