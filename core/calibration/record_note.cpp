#include "core/calibration/record_note.h"

#include <sstream>
#include <string_view>

namespace mirrorarm::calibration {
namespace {

std::string_view name(BoardKind kind) {
  switch (kind) {
    case BoardKind::kChessboard:
      return "chessboard";
    case BoardKind::kCircles:
      return "circles";
    case BoardKind::kAsymmetricCircles:
      return "asymmetric-circles";
    case BoardKind::kDotPlate:
      return "dots";
  }
  return "";
}

}  // namespace

std::string textOf(const Board& board) {
  std::ostringstream text;
  text << name(board.kind) << ':' << board.columns << 'x' << board.rows << ':' << board.spacing_m;
  return text.str();
}

camera::CalibrationNote noteOf(const std::string& method, const Board& board, double rms_px,
                               std::span<const ViewResidual> views, const HoldOut& hold_out) {
  camera::CalibrationNote note;
  note.method = method;
  note.software = "mirrorarm " MIRRORARM_VERSION;
  note.board = textOf(board);
  note.rms_px = rms_px;
  for (const auto& view : views)
    (view.is_outlier ? note.outliers : view.is_held_out ? note.held_out : note.images).push_back(view.name);
  note.hold_out_method = hold_out.parts == 0
                             ? "views kept out of the solution"
                             : "cross-validation in " + std::to_string(hold_out.parts) + " parts";
  note.hold_out_epipolar_px = hold_out.epipolar_px;
  note.hold_out_px = hold_out.reprojection_px;
  note.square_mean_percent = hold_out.square_mean_percent;
  note.square_std_percent = hold_out.square_std_percent;
  note.depth_rms_m = hold_out.depth_rms_m;
  return note;
}

}  // namespace mirrorarm::calibration
