#include "core/calibration/board.h"

#include <array>
#include <charconv>
#include <optional>

#include "core/calibration/dot_pattern.h"
#include "core/common/csv.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kFewest = 3;
constexpr int kMost = 200;
constexpr double kLargestSpacing_m = 1.0;

struct Named {
  std::string_view name;
  BoardKind kind;
};
constexpr std::array<Named, 4> kKinds = {{{"chessboard", BoardKind::kChessboard},
                                          {"circles", BoardKind::kCircles},
                                          {"asymmetric-circles", BoardKind::kAsymmetricCircles},
                                          {"dots", BoardKind::kDotPlate}}};

std::optional<int> count(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value >= kFewest && value <= kMost ? std::optional(value) : std::nullopt;
}

bool readKind(std::string_view text, Board& board) {
  for (const auto& [name, kind] : kKinds) {
    if (text != name) continue;
    board.kind = kind;
    return true;
  }
  return false;
}

bool readSize(std::string_view text, Board& board) {
  const auto cells = splitCells(text, 'x');
  if (cells.size() != 2) return false;
  const auto columns = count(cells[0]);
  const auto rows = count(cells[1]);
  if (!columns || !rows) return false;
  board.columns = *columns;
  board.rows = *rows;
  return true;
}

}  // namespace

Expected<Board, std::string> boardOf(std::string_view text) {
  const auto cells = splitCells(text, ':');
  Board board;
  if (cells.size() != 3) return unexpected(std::string("is not KIND:COLUMNSxROWS:METRES"));
  if (!readKind(cells[0], board))
    return unexpected("kind '" + cells[0] + "' is none of chessboard, circles, asymmetric-circles, dots");
  if (!readSize(cells[1], board))
    return unexpected("size '" + cells[1] + "' is not COLUMNSxROWS, each from 3 to 200");
  if (!parseNumber(cells[2], board.spacing_m) || board.spacing_m <= 0.0 ||
      board.spacing_m > kLargestSpacing_m)
    return unexpected("spacing '" + cells[2] + "' is not a length in metres above 0 and up to 1");
  return board;
}

std::vector<Eigen::Vector3d> boardPoints(const Board& board) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(board.columns) * static_cast<std::size_t>(board.rows));
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column) {
      const int x = board.kind == BoardKind::kAsymmetricCircles ? 2 * column + row % 2 : column;
      points.emplace_back(x * board.spacing_m, row * board.spacing_m, 0.0);
    }
  return points;
}

Eigen::Vector3d boardMiddle(const Board& board) {
  const bool is_shifted = board.kind == BoardKind::kAsymmetricCircles;
  const int steps = is_shifted ? 2 * board.columns - 1 : board.columns - 1;
  return 0.5 * board.spacing_m * Eigen::Vector3d(steps, board.rows - 1, 0.0);
}

std::vector<double> discDiameters_m(const Board& board) {
  std::vector<double> diameters(static_cast<std::size_t>(board.columns) *
                                static_cast<std::size_t>(board.rows));
  if (board.kind != BoardKind::kDotPlate) return diameters;
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const int at = static_cast<int>(i);
    const bool is_large = isLargeDot(at % board.columns, at / board.columns);
    diameters[i] = (is_large ? kLargeDotShare : kSmallDotShare) * board.spacing_m;
  }
  return diameters;
}

std::vector<std::pair<std::size_t, std::size_t>> boardNeighbours(const Board& board) {
  const auto columns = static_cast<std::size_t>(board.columns);
  const auto rows = static_cast<std::size_t>(board.rows);
  std::vector<std::pair<std::size_t, std::size_t>> neighbours;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t at = row * columns + column;
      if (column + 1 < columns) neighbours.emplace_back(at, at + 1);
      if (row + 1 < rows) neighbours.emplace_back(at, at + columns);
    }
  return neighbours;
}

}  // namespace mirrorarm::calibration
