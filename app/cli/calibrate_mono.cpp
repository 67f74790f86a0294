#include <iomanip>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/camera_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

struct Wish : LensWish {
  std::string images;
};

void run(const Wish& wish, Context& context) {
  const auto board = wishedBoard(wish);
  const auto images = orRefuse(calibration::readBoardImages(wish.images, board));
  const auto solved = calibrateCamera(board, images.views, images.size, wishedModel(wish));
  if (!solved) refuseViews(wish.images, solved.error(), images);
  calibration::CameraRecord record{solved->camera, {}};
  record.calibration.date = isoUtcNow();
  record.calibration.method = "bundle adjustment of the lens and the board's poses";
  record.calibration.rms_px = solved->rms_px;
  orFail(writeCameraFile(wish.out, record));
  context.result["rms_px"] = solved->rms_px;
  context.result["model"] = wish.model;
  context.result["views"] = solved->views;
  context.result["outliers"] = solved->outliers;
  context.result["not_found"] = images.not_found;
  if (context.json) return;
  std::cout << std::fixed << std::setprecision(3) << "Reprojection " << solved->rms_px << " px rms over "
            << solved->views << " views; written to " << wish.out << "\n";
  tellLeftOut(solved->outliers, images);
}

}  // namespace

void addCalibrateMono(CLI::App& calibrate, Context& context) {
  CLI::App* command = addCommand(calibrate, context, "mono", "One camera's lens from images of a board",
                                 "mirrorarm-cli calibrate mono left/ --board chessboard:9x6:0.025 "
                                 "--model brown_conrady --out camera.yaml");
  const auto wish = std::make_shared<Wish>();
  command->add_option("images", wish->images, "Folder with the images, or a path with one *")->required();
  addLensOptions(*command, *wish);
  command->add_option("--out", wish->out, "The camera.yaml to write")->required();
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
