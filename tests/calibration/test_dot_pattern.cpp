#include <array>
#include <bit>
#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include "core/calibration/board.h"
#include "core/calibration/dot_pattern.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kWindow = 4;
using Code = std::uint32_t;

/// A window of 4 x 4 dots, turned (swap and mirror) in one of eight ways.
Code windowAt(int column, int row, int symmetry) {
  Code code = 0;
  for (int y = 0; y < kWindow; ++y)
    for (int x = 0; x < kWindow; ++x) {
      int across = symmetry & 1 ? kWindow - 1 - x : x;
      int down = symmetry & 2 ? kWindow - 1 - y : y;
      if (symmetry & 4) std::swap(across, down);
      code |= static_cast<Code>(isLargeDot(column + across, row + down)) << (kWindow * y + x);
    }
  return code;
}

/// Fewest dots in which two windows of a plate differ, turned and mirrored in any way.
int leastDifference(int columns, int rows) {
  std::vector<Code> seen;
  int least = kWindow * kWindow;
  for (int row = 0; row + kWindow <= rows; ++row)
    for (int column = 0; column + kWindow <= columns; ++column) {
      const Code upright = windowAt(column, row, 0);
      for (const Code other : seen) least = std::min(least, std::popcount(other ^ upright));
      for (int symmetry = 0; symmetry < 8; ++symmetry) {
        seen.push_back(windowAt(column, row, symmetry));
        if (symmetry > 0) least = std::min(least, std::popcount(seen.back() ^ upright));
      }
    }
  return least;
}

TEST(DotPattern, EveryWindowOfThePlateIsUnlikeAllOthersHoweverHeld) {
  EXPECT_GE(leastDifference(9, 7), 3);
  EXPECT_GE(leastDifference(13, 9), 2);
}

TEST(DotPattern, NoWindowComesTwiceOnAnyPlate) {
  std::set<Code> seen;
  for (int row = 0; row + kWindow <= 200; ++row)
    for (int column = 0; column + kWindow <= 200; ++column)
      ASSERT_TRUE(seen.insert(windowAt(column, row, 0)).second) << column << " " << row;
}

TEST(DotPattern, EveryPlateTellsItsTurns) {
  for (int rows = 4; rows <= 20; ++rows)
    for (int columns = 4; columns <= 20; ++columns) {
      int half_turn = 0, quarter_turn = 0;
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
          const bool is_large = isLargeDot(column, row);
          half_turn += is_large != isLargeDot(columns - 1 - column, rows - 1 - row) ? 1 : 0;
          if (rows == columns) quarter_turn += is_large != isLargeDot(row, columns - 1 - column) ? 1 : 0;
        }
      EXPECT_GE(half_turn, 3) << columns << "x" << rows;
      EXPECT_TRUE(rows != columns || quarter_turn >= 3) << columns << "x" << rows;
    }
}

TEST(DotPattern, StartsAsTheManualShowsIt) {
  constexpr std::array<std::string_view, 7> manual = {".OO.OOOO.", ".OO.O...O", ".O.OO.O..", "O..O.O...",
                                                      "O..OO....", "..OO.OO.O", "O...OOO.."};
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 9; ++column)
      EXPECT_EQ(isLargeDot(column, row),
                manual[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == 'O');
}

TEST(DotPattern, GivesTheDiscsTheirDiameters) {
  const auto diameters = discDiameters_m(*boardOf("dots:9x7:0.03"));
  ASSERT_EQ(diameters.size(), 63u);
  EXPECT_DOUBLE_EQ(diameters[0], 0.012);
  EXPECT_DOUBLE_EQ(diameters[1], 0.018);
  EXPECT_EQ(discDiameters_m(*boardOf("chessboard:9x6:0.03")), std::vector<double>(54, 0.0));
  EXPECT_EQ(discDiameters_m(*boardOf("circles:9x6:0.03")), std::vector<double>(54, 0.0));
}

}  // namespace
}  // namespace mirrorarm::calibration
