#include <iomanip>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/point_residuals.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/rig_file.h"
#include "core/common/atomic_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

using calibration::StereoCalibration;

struct Wish : LensWish {
  std::string left;
  std::string right;
  std::string left_serial;
  std::string right_serial;
  std::string residuals;
  std::size_t hold_out = 0;
};

LensReport reportOf(const StereoCalibration& solved) {
  return {solved.rms_px,      solved.rig.left.intrinsics().model,
          solved.views,       solved.outliers,
          *solved.hold_out,   solved.residuals,
          solved.board_shape, solved.trials};
}

nlohmann::ordered_json sigmaOf(const StereoCalibration& solved) {
  const Eigen::Vector3d turn_rad = solved.bar_sigma.head<3>();
  const Eigen::Vector3d shift_mm = 1e3 * solved.bar_sigma.tail<3>();
  return {{"left", toJson(solved.lens_sigma[0])},
          {"right", toJson(solved.lens_sigma[1])},
          {"bar_turn_rad", {turn_rad.x(), turn_rad.y(), turn_rad.z()}},
          {"bar_shift_mm", {shift_mm.x(), shift_mm.y(), shift_mm.z()}}};
}

void complete(const Wish& wish, camera::CalibrationNote& note) {
  note.date = isoUtcNow();
  note.left_serial = wish.left_serial;
  note.right_serial = wish.right_serial;
}

void writeResiduals(std::ostream& out, const std::vector<calibration::PointResidual>& residuals) {
  out << "view,camera,point,dx_px,dy_px\n";
  for (const auto& [view, camera, point, offset_px] : residuals)
    out << view << ',' << (camera == 0 ? "left" : "right") << ',' << point << ',' << offset_px.x() << ','
        << offset_px.y() << '\n';
}

void run(const Wish& wish, Context& context) {
  const auto board = wishedBoard(wish);
  const auto images = orRefuse(calibration::readBoardImagePairs(wish.left, wish.right, board));
  auto solved = calibrateStereo(board, images.views, images.size, wishedModel(wish), wish.hold_out);
  if (!solved) refuseViews(wish.left, solved.error(), images);
  complete(wish, solved->rig.calibration);
  orFail(camera::writeRig(wish.out, solved->rig));
  if (!wish.residuals.empty())
    orFail(writeWhole(wish.residuals, [&](std::ostream& out) {
      writeResiduals(out, pointResiduals(solved->rig, board, images.views));
    }));
  const auto report = reportOf(*solved);
  const double baseline_mm = solved->rig.X_RC.translation().norm() * 1e3;
  fillLensReport(report, images, context);
  context.result["baseline_mm"] = baseline_mm;
  context.result["sigma"] = sigmaOf(*solved);
  if (context.json) return;
  tellLensReport(report, images, wish.out);
  std::cout << "Cameras " << std::setprecision(2) << baseline_mm << " mm apart\n";
}

}  // namespace

void addCalibrateStereo(CLI::App& calibrate, Context& context) {
  CLI::App* command = addCommand(calibrate, context, "stereo", "Both cameras and the bar between them",
                                 "mirrorarm-cli calibrate stereo left/ right/ --board chessboard:9x6:0.025 "
                                 "--hold-out 2 --out rig.yaml --json");
  const auto wish = std::make_shared<Wish>();
  command->add_option("left", wish->left, "Folder with the left images, or a path with one *")->required();
  command->add_option("right", wish->right, "The same for the right ones, matched by number or name")
      ->required();
  addLensOptions(*command, *wish, "rig.yaml");
  command
      ->add_option(
          "--hold-out", wish->hold_out,
          "Keep every N-th view out of the solution and measure on it; the rig is solved from the others. "
          "Without: solved from all, measured by cross-validation")
      ->check(CLI::Range(2, 1000));
  command->add_option("--residuals", wish->residuals,
                      "A table of every point's distance from where the rig puts it, CSV");
  command->add_option("--left-serial", wish->left_serial, "Serial number of the left camera, for the record");
  command->add_option("--right-serial", wish->right_serial, "The same of the right one");
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
