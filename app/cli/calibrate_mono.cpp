#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/camera_calibration.h"
#include "core/calibration/camera_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

struct Wish : LensWish {
  std::string images;
  std::string serial;
};

LensReport reportOf(const calibration::CameraCalibration& solved) {
  return {solved.rms_px,      solved.camera.intrinsics().model,
          solved.views,       solved.outliers,
          solved.hold_out,    solved.residuals,
          solved.board_shape, solved.trials};
}

void run(const Wish& wish, Context& context) {
  const auto board = wishedBoard(wish);
  const auto images = orRefuse(calibration::readBoardImages(wish.images, board));
  const auto solved = calibrateCamera(board, images.views, images.size, wishedModel(wish));
  if (!solved) refuseViews(wish.images, solved.error(), images);
  calibration::CameraRecord record{solved->camera, solved->note};
  record.calibration.date = isoUtcNow();
  record.calibration.left_serial = wish.serial;
  orFail(writeCameraFile(wish.out, record));
  const auto report = reportOf(*solved);
  fillLensReport(report, images, context);
  context.result["sigma"] = toJson(solved->sigma);
  if (!context.json) tellLensReport(report, images, wish.out);
}

}  // namespace

void addCalibrateMono(CLI::App& calibrate, Context& context) {
  CLI::App* command = addCommand(calibrate, context, "mono", "One camera's lens from images of a board",
                                 "mirrorarm-cli calibrate mono left/ --board chessboard:9x6:0.025 "
                                 "--out camera.yaml");
  const auto wish = std::make_shared<Wish>();
  command->add_option("images", wish->images, "Folder with the images, or a path with one *")->required();
  addLensOptions(*command, *wish, "camera.yaml");
  command->add_option("--serial", wish->serial, "Serial number of the camera, for the record");
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
