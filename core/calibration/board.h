#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/common/expected.h"

namespace mirrorarm::calibration {

enum class BoardKind {
  kChessboard,         ///< points are the inner corners
  kCircles,            ///< centres on a rectangular grid
  kAsymmetricCircles,  ///< every second row shifted by half a step: OpenCV's asymmetric pattern
  kDotPlate,           ///< bright discs on dark ground, small and large ones: see dot_pattern.h
};

/// A flat calibration board. Its frame M has x along a row, y from row to row and z away from the viewer.
struct Board {
  BoardKind kind = BoardKind::kChessboard;
  int columns = 0;         ///< points in a row
  int rows = 0;            ///< rows
  double spacing_m = 0.0;  ///< side of a square; step from centre to centre; asymmetric: step from row to row
};

/// A board as the command line writes it: "chessboard:9x6:0.025", "circles:6x6:0.034",
/// "asymmetric-circles:4x11:0.02" or "dots:9x7:0.03", columns by rows and metres. The error is the reason.
[[nodiscard]] Expected<Board, std::string> boardOf(std::string_view text);

/// The points in frame M [m], row by row, z = 0.
[[nodiscard]] std::vector<Eigen::Vector3d> boardPoints(const Board& board);

/// The middle between the outermost points, in frame M [m].
[[nodiscard]] Eigen::Vector3d boardMiddle(const Board& board);

/// Diameters of the discs [m], a point each: of a dot plate small and large ones, kSmallDotShare and
/// kLargeDotShare of the spacing. 0 where there is no disc (chessboard) or its size is not known (circles).
[[nodiscard]] std::vector<double> discDiameters_m(const Board& board);

/// Indices of neighbouring points, along rows and from row to row: the lengths that a measured board is
/// checked by.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> boardNeighbours(const Board& board);

}  // namespace mirrorarm::calibration
