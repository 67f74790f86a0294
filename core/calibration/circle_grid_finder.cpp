#include "core/calibration/circle_grid_finder.h"

#include <map>
#include <optional>
#include <utility>

#include "core/calibration/disc_lattice.h"
#include "core/calibration/seen_discs.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kBlur_px = 1.0;       // sharp images and coarse prints lie to either side
constexpr LatticeLimits kLimits;       // wide ones, for coarse prints
constexpr double kNextRowShare = 0.5;  // of a row's places that hold discs, where the board goes on

vision::FinderSettings settings(bool dark) {
  auto settings = vision::plateSettings();
  settings.dark_on_bright = dark;
  settings.blur_px = kBlur_px;
  return settings;
}

/// Where a point lies, in steps of the board; asymmetric rows are shifted by one of the half steps they
/// count.
Place cellOf(const Board& board, int column, int row) {
  if (board.kind == BoardKind::kCircles) return {column, row};
  return {2 * column + (row & 1), row};
}

/// The discs of a lattice by their cells. The lattice of an asymmetric board stands on its corner.
class Cells {
 public:
  Cells(std::span<const PlacedDisc> lattice, const Board& board) {
    Eigen::Matrix2i to_cell = Eigen::Matrix2i::Identity();
    if (board.kind == BoardKind::kAsymmetricCircles) to_cell << 1, -1, 1, 1;
    for (const auto& placed : lattice) put(to_cell * placed.place, placed.disc);
  }
  [[nodiscard]] const Place& low() const { return low_; }
  [[nodiscard]] const Place& high() const { return high_; }
  [[nodiscard]] std::optional<std::size_t> at(const Place& cell) const {
    const auto found = discs_.find({cell.x(), cell.y()});
    return found == discs_.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] Cells quarterTurned() const {
    Cells turned;
    for (const auto& [cell, disc] : discs_) turned.put({-cell.second, cell.first}, disc);
    return turned;
  }

 private:
  Cells() = default;
  void put(const Place& cell, std::size_t disc) {
    low_ = discs_.empty() ? cell : Place(low_.cwiseMin(cell));
    high_ = discs_.empty() ? cell : Place(high_.cwiseMax(cell));
    discs_[{cell.x(), cell.y()}] = disc;
  }
  std::map<std::pair<int, int>, std::size_t> discs_;
  Place low_ = Place::Zero(), high_ = Place::Zero();
};

/// The board's discs in their order, where all are there with the board's first cell at `shift`.
std::optional<std::vector<std::size_t>> wholeAt(const Cells& cells, const Board& board, const Place& shift) {
  std::vector<std::size_t> order;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column) {
      const auto disc = cells.at(cellOf(board, column, row) + shift);
      if (!disc) return std::nullopt;
      order.push_back(*disc);
    }
  return order;
}

bool hasColumn(const Cells& cells, const Board& board, const Place& shift, int column) {
  int there = 0;
  for (int row = 0; row < board.rows; ++row) there += cells.at(cellOf(board, column, row) + shift) ? 1 : 0;
  return there > kNextRowShare * board.rows;
}

bool hasRow(const Cells& cells, const Board& board, const Place& shift, int row) {
  int there = 0;
  for (int column = 0; column < board.columns; ++column)
    there += cells.at(cellOf(board, column, row) + shift) ? 1 : 0;
  return there > kNextRowShare * board.columns;
}

bool goesOn(const Cells& cells, const Board& board, const Place& shift) {
  return hasColumn(cells, board, shift, -1) || hasColumn(cells, board, shift, board.columns) ||
         hasRow(cells, board, shift, -1) || hasRow(cells, board, shift, board.rows);
}

/// The first place in this turn where the whole board is.
Expected<std::vector<std::size_t>, BoardMiss> placedIn(const Cells& cells, const Board& board) {
  const bool is_shifted = board.kind == BoardKind::kAsymmetricCircles;
  const Place last = cells.high() - cellOf(board, board.columns - 1, board.rows - 1);
  for (int y = cells.low().y(); y <= last.y(); ++y)
    for (int x = cells.low().x() - (is_shifted ? 1 : 0); x <= last.x() + (is_shifted ? 1 : 0); ++x) {
      auto order = wholeAt(cells, board, {x, y});
      if (!order) continue;
      if (goesOn(cells, board, {x, y})) return unexpected(BoardMiss::kLargerBoard);
      return *std::move(order);
    }
  return unexpected(BoardMiss::kNotFound);
}

Expected<Sighting, BoardMiss> findCircles(const camera::ImageView& image, const Board& board, bool dark) {
  const auto discs = seenDiscs(image, settings(dark));
  Cells cells(largestLattice(discs, kLimits), board);
  for (int turn = 0; turn < 4; ++turn, cells = cells.quarterTurned()) {
    const auto order = placedIn(cells, board);
    if (!order && order.error() == BoardMiss::kNotFound) continue;
    if (!order) return unexpected(order.error());
    Sighting sighting;
    for (const std::size_t disc : *order) {
      sighting.push_back(discs[disc]);
      sighting.back().point = static_cast<int>(sighting.size()) - 1;
    }
    return sighting;
  }
  return unexpected(BoardMiss::kNotFound);
}

}  // namespace

Expected<Sighting, BoardMiss> findCircleGrid(const camera::ImageView& image, const Board& board) {
  auto found = findCircles(image, board, true);
  if (found || found.error() == BoardMiss::kLargerBoard) return found;
  return findCircles(image, board, false);
}

}  // namespace mirrorarm::calibration
