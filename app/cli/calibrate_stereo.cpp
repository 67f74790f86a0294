#include <iomanip>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/rig_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

using calibration::HoldOut;
using calibration::StereoCalibration;

struct Wish : LensWish {
  std::string left;
  std::string right;
  std::size_t hold_out = 0;
};

nlohmann::ordered_json toJson(const std::optional<HoldOut>& hold_out) {
  if (!hold_out) return nullptr;
  return {{"epipolar_px", hold_out->epipolar_px},
          {"square_mean_percent", hold_out->square_mean_percent},
          {"square_std_percent", hold_out->square_std_percent},
          {"views", hold_out->views}};
}

void tell(const StereoCalibration& solved, const std::string& out) {
  std::cout << std::fixed << std::setprecision(3) << "Reprojection " << solved.rms_px << " px rms over "
            << solved.views << " views, baseline " << solved.rig.X_RC.translation().norm() * 1e3
            << " mm; written to " << out << "\n";
  if (const auto& kept = solved.hold_out)
    std::cout << "On " << kept->views << " views kept out: epipolar " << kept->epipolar_px
              << " px rms, squares " << kept->square_mean_percent << " % off, std "
              << kept->square_std_percent << " %\n";
}

void run(const Wish& wish, Context& context) {
  const auto board = wishedBoard(wish);
  const auto images = orRefuse(calibration::readBoardImagePairs(wish.left, wish.right, board));
  auto solved = calibrateStereo(board, images.views, images.size, wishedModel(wish), wish.hold_out);
  if (!solved) refuseViews(wish.left, solved.error(), images);
  solved->rig.calibration.date = isoUtcNow();
  orFail(camera::writeRig(wish.out, solved->rig));
  context.result["rms_px"] = solved->rms_px;
  context.result["hold_out"] = toJson(solved->hold_out);
  context.result["model"] = wish.model;
  context.result["views"] = solved->views;
  context.result["outliers"] = solved->outliers;
  context.result["not_found"] = images.not_found;
  if (context.json) return;
  tell(*solved, wish.out);
  tellLeftOut(solved->outliers, images);
}

}  // namespace

void addCalibrateStereo(CLI::App& calibrate, Context& context) {
  CLI::App* command = addCommand(calibrate, context, "stereo", "Both cameras and the bar between them",
                                 "mirrorarm-cli calibrate stereo left/ right/ --board chessboard:9x6:0.025 "
                                 "--model brown_conrady --hold-out 2 --out rig.yaml --json");
  const auto wish = std::make_shared<Wish>();
  command->add_option("left", wish->left, "Folder with the left images, or a path with one *")->required();
  command->add_option("right", wish->right, "The same for the right ones, matched by number or name")
      ->required();
  addLensOptions(*command, *wish);
  command
      ->add_option(
          "--hold-out", wish->hold_out,
          "Keep every N-th view out of the solution and measure on it; the rig is solved from the others")
      ->check(CLI::Range(2, 1000));
  command->add_option("--out", wish->out, "The rig.yaml to write")->required();
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
