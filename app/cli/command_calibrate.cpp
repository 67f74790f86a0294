#include <iostream>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "app/cli/commands.h"

namespace mirrorarm::cli {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string line;
  for (const auto& name : names) line += (line.empty() ? "" : ", ") + name;
  return line;
}

}  // namespace

void addLensOptions(CLI::App& command, LensWish& wish) {
  command
      .add_option(
          "--board", wish.board,
          "chessboard:9x6:0.025, circles:6x6:0.034 or asymmetric-circles:4x11:0.02: points in a row x rows, "
          "step in metres")
      ->required();
  command.add_option("--model", wish.model, "Lens model")
      ->check(CLI::IsMember(std::vector<std::string>{"brown_conrady", "kannala_brandt"}))
      ->required();
}

calibration::Board wishedBoard(const LensWish& wish) {
  const auto board = calibration::boardOf(wish.board);
  if (!board) throw InputRefused("--board " + wish.board + ": " + board.error());
  return *board;
}

camera::LensModel wishedModel(const LensWish& wish) { return camera::lensModelOf(wish.model).value(); }

void refuseViews(const std::string& images, calibration::CalibrationError error,
                 const calibration::BoardImages& read) {
  std::string line = images + ": " + std::string(reason(error));
  if (!read.not_found.empty()) line += "; board not found whole in " + joined(read.not_found);
  throw InputRefused(line);
}

void tellLeftOut(const std::vector<std::string>& outliers, const calibration::BoardImages& read) {
  if (!outliers.empty()) std::cout << "Left out, far worse than the others: " << joined(outliers) << "\n";
  if (!read.not_found.empty()) std::cout << "Board not found whole in: " << joined(read.not_found) << "\n";
}

void addCalibrate(CLI::App& app, Context& context) {
  CLI::App* calibrate =
      app.add_subcommand("calibrate", "Solve lenses, the stereo rig or the camera on the robot");
  calibrate->require_subcommand(1);
  addCalibrateHandEye(*calibrate, context);
  addCalibrateMono(*calibrate, context);
  addCalibrateStereo(*calibrate, context);
}

}  // namespace mirrorarm::cli
