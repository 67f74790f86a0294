#include <filesystem>
#include <stdexcept>

#include "benchmarks/calibration/opencv_stereo.h"
#include "benchmarks/calibration/suite.h"
#include "core/calibration/board_images.h"
#include "core/calibration/hold_out.h"
#include "core/calibration/stereo_calibration.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;

constexpr auto kModel = camera::LensModel::kBrownConrady;
constexpr std::size_t kHoldOut = 2;  // every second view
constexpr double kGoalRms_px = 0.22;
constexpr double kGoalEpipolar_px = 0.20;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<BoardView> everySecond(const std::vector<BoardView>& views, std::size_t first) {
  std::vector<BoardView> picked;
  for (std::size_t i = first; i < views.size(); i += kHoldOut) picked.push_back(views[i]);
  return picked;
}

/// OpenCV's answer to the first, third, .. views, measured on the others.
double epipolarByOpenCv_px(const Board& board, const BoardImages& images) {
  const auto solved = solveByOpenCv(board, everySecond(images.views, 0), images.size, kModel);
  return solved ? measureHoldOut(solved->rig, board, everySecond(images.views, 1)).epipolar_px : kNone;
}

}  // namespace

void measurePhotographs(Run& run) {
  const std::filesystem::path folder = SHARED_DATA "/opencv-chess-stereo";
  if (!std::filesystem::exists(folder)) return;
  const auto board = boardOf("chessboard:9x6:0.025").value();
  const auto images = readBoardImagePairs(folder, folder, board);
  if (!images) throw std::runtime_error(describe(images.error()));
  const auto all = calibrateStereo(board, images->views, images->size, kModel);
  const auto half = calibrateStereo(board, images->views, images->size, kModel, kHoldOut);
  if (!all || !half) throw std::runtime_error("the photographs do not give a rig");
  const auto by_opencv = solveByOpenCv(board, images->views, images->size, kModel);
  run.report.rows.push_back({"",
                             "stereo reprojection, two radial terms",
                             "<= 0.22 px",
                             {{"rms", all->rms_px, "px"}, {"views", static_cast<double>(all->views), ""}},
                             {{"OpenCV", by_opencv ? by_opencv->rms_px : kNone, "px"}},
                             all->rms_px <= kGoalRms_px});
  const auto& kept = *half->hold_out;
  run.report.rows.push_back({"",
                             "on every second view, kept out",
                             "<= 0.20 px",
                             {{"epipolar rms", kept.epipolar_px, "px"},
                              {"squares, mean error", kept.square_mean_percent, "%"},
                              {"squares, std", kept.square_std_percent, "%"},
                              {"depth rms", 1e3 * kept.depth_rms_m, "mm"}},
                             {{"OpenCV", epipolarByOpenCv_px(board, *images), "px"}},
                             kept.epipolar_px <= kGoalEpipolar_px});
}

}  // namespace mirrorarm::benchmarks::calibration
