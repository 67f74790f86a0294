#include "core/calibration/board_finder.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "core/calibration/chessboard_finder.h"
#include "core/calibration/circle_grid_finder.h"
#include "core/calibration/dot_plate_finder.h"

namespace mirrorarm::calibration {
namespace {

std::size_t at(const Board& board, int column, int row) {
  return static_cast<std::size_t>(row * board.columns + column);
}

Sighting renumbered(Sighting whole) {
  for (std::size_t i = 0; i < whole.size(); ++i) whole[i].point = static_cast<int>(i);
  return whole;
}

/// The board's points after a quarter turn; for as many rows as columns.
Sighting quarterTurned(const Sighting& whole, const Board& board) {
  Sighting turned(whole.size());
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      turned[at(board, column, row)] = whole[at(board, row, board.rows - 1 - column)];
  return renumbered(std::move(turned));
}

Sighting halfTurned(const Sighting& whole) { return renumbered(Sighting(whole.rbegin(), whole.rend())); }

std::vector<Sighting> alikeOrders(const Sighting& whole, const Board& board) {
  std::vector<Sighting> orders = {whole, halfTurned(whole)};
  if (board.rows != board.columns || board.kind == BoardKind::kAsymmetricCircles) return orders;
  orders.push_back(quarterTurned(whole, board));
  orders.push_back(halfTurned(orders[2]));
  return orders;
}

bool hasOneOrder(const Board& board) {
  switch (board.kind) {
    case BoardKind::kChessboard:
      return (board.columns + board.rows) % 2 == 1;
    case BoardKind::kCircles:
      return false;
    case BoardKind::kAsymmetricCircles:
      return board.rows % 2 == 1;
    case BoardKind::kDotPlate:
      return true;
  }
  return false;
}

Eigen::Vector2d middleOf(const Sighting& whole) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& seen : whole) sum += seen.pixel;
  return sum / static_cast<double>(whole.size());
}

double disagreement(const Sighting& a, const Sighting& b) {
  const Eigen::Vector2d shift = middleOf(b) - middleOf(a);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (b[i].pixel - a[i].pixel - shift).squaredNorm();
  return sum;
}

}  // namespace

std::string_view reason(BoardMiss miss) {
  return miss == BoardMiss::kNotFound
             ? "the board is not found: check its kind and size, the light, and that nothing covers it"
             : "the pattern goes on beyond the size asked for: give the size of the whole board";
}

Expected<Sighting, BoardMiss> findBoard(const camera::ImageView& image, const Board& board) {
  switch (board.kind) {
    case BoardKind::kChessboard:
      return findChessboard(image, board);
    case BoardKind::kCircles:
    case BoardKind::kAsymmetricCircles:
      return findCircleGrid(image, board);
    case BoardKind::kDotPlate:
      return findDotPlate(image, board);
  }
  return unexpected(BoardMiss::kNotFound);
}

Sighting orderedLike(const Sighting& reference, const Sighting& sighting, const Board& board) {
  if (hasOneOrder(board)) return sighting;
  assert(reference.size() == sighting.size());
  const auto orders = alikeOrders(sighting, board);
  return *std::min_element(orders.begin(), orders.end(), [&](const Sighting& a, const Sighting& b) {
    return disagreement(reference, a) < disagreement(reference, b);
  });
}

}  // namespace mirrorarm::calibration
