#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "app/cli/commands.h"

namespace mirrorarm::cli {

std::string joined(const std::vector<std::string>& names) {
  std::string line;
  for (const auto& name : names) line += (line.empty() ? "" : ", ") + name;
  return line;
}

void addLensOptions(CLI::App& command, LensWish& wish, const std::string& out_file) {
  command
      .add_option("--board", wish.board,
                  "chessboard:9x6:0.025, circles:6x6:0.034, asymmetric-circles:4x11:0.02 or dots:9x7:0.03: "
                  "points in a row "
                  "x rows, step in metres")
      ->required();
  command
      .add_option("--model", wish.model, "Lens model; without it the one that errs less on views kept out")
      ->check(CLI::IsMember(std::vector<std::string>{"brown_conrady", "kannala_brandt"}));
  command.add_option("--out", wish.out, "The " + out_file + " to write")->required();
}

calibration::Board wishedBoard(const LensWish& wish) {
  const auto board = calibration::boardOf(wish.board);
  if (!board) throw InputRefused("--board " + wish.board + ": " + board.error());
  return *board;
}

std::optional<camera::LensModel> wishedModel(const LensWish& wish) { return camera::lensModelOf(wish.model); }

void refuseViews(const std::string& images, const calibration::CalibrationRefusal& refusal,
                 const calibration::BoardImages& read) {
  std::string line = images + ": " + reason(refusal);
  if (const auto left_out = leftOut(read); !left_out.empty()) line += "; " + left_out;
  throw InputRefused(line);
}

void addCalibrate(CLI::App& app, Context& context) {
  CLI::App* calibrate =
      app.add_subcommand("calibrate", "Solve lenses, the stereo rig or the camera on the robot");
  calibrate->require_subcommand(1);
  addCalibrateClock(*calibrate, context);
  addCalibrateHandEye(*calibrate, context);
  addCalibrateMono(*calibrate, context);
  addCalibrateStereo(*calibrate, context);
}

}  // namespace mirrorarm::cli
