#include "ui/model/board_overlay.h"

#include <algorithm>

namespace mirrorarm::ui {
namespace {

QPointF onImage(const Eigen::Vector2d& pixel) { return {pixel.x(), pixel.y()}; }

/// The outer points of a board, once around.
std::vector<int> rimOf(const calibration::Board& board) {
  std::vector<int> rim;
  const int last_row = (board.rows - 1) * board.columns;
  for (int i = 0; i < board.columns; ++i) rim.push_back(i);
  for (int row = 1; row < board.rows; ++row) rim.push_back((row + 1) * board.columns - 1);
  for (int i = board.columns - 2; i >= 0; --i) rim.push_back(last_row + i);
  for (int row = board.rows - 2; row > 0; --row) rim.push_back(row * board.columns);
  return rim;
}

bool isCorner(int point, const calibration::Board& board) {
  const int last_row = (board.rows - 1) * board.columns;
  return point == 0 || point == board.columns - 1 || point == last_row ||
         point == last_row + board.columns - 1;
}

void addSeen(const calibration::Sighting& seen, const calibration::Board& board, BoardOverlay& overlay) {
  for (const auto& point : seen)
    overlay.points.push_back(
        {onImage(point.pixel), isCorner(point.point, board) ? QString::number(point.point + 1) : QString()});
  for (const int wanted : rimOf(board)) {
    const auto found = std::ranges::lower_bound(seen, wanted, {}, &calibration::SeenPoint::point);
    if (found != seen.end() && found->point == wanted) overlay.outline_px.push_back(onImage(found->pixel));
  }
}

/// Nothing where a part of it lies outside the lens model's range.
std::vector<QPointF> projected(const calibration::Board& board, const camera::CameraModel& camera,
                               const RigidTransform& X_KM) {
  const auto points_M = calibration::boardPoints(board);
  std::vector<QPointF> outline;
  for (const int index : rimOf(board)) {
    const auto pixel = camera.project(X_KM * points_M[static_cast<std::size_t>(index)]);
    if (!pixel) return {};
    outline.push_back(onImage(*pixel));
  }
  return outline;
}

}  // namespace

std::array<BoardOverlay, 2> boardOverlaysOf(const station::CalibrationSnapshot& snapshot,
                                            const std::optional<camera::StereoRig>& rig) {
  std::array<BoardOverlay, 2> overlays;
  for (std::size_t camera = 0; camera < overlays.size(); ++camera) {
    overlays[camera].cells = snapshot.coverage.image[camera];
    if (snapshot.frame) addSeen(snapshot.frame->view.seen[camera], snapshot.board, overlays[camera]);
  }
  if (rig && snapshot.proposal) {
    overlays[0].wished_px = projected(snapshot.board, rig->left, snapshot.proposal->X_CM);
    overlays[1].wished_px = projected(snapshot.board, rig->right, rig->X_RC * snapshot.proposal->X_CM);
  }
  return overlays;
}

}  // namespace mirrorarm::ui
