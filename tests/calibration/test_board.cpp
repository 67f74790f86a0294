#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/calibration/board_finder.h"

namespace mirrorarm::calibration {
namespace {

TEST(Board, IsReadAsWritten) {
  const auto board = boardOf("asymmetric-circles:4x11:0.02");
  ASSERT_TRUE(board);
  EXPECT_EQ(board->kind, BoardKind::kAsymmetricCircles);
  EXPECT_EQ(board->columns, 4);
  EXPECT_EQ(board->rows, 11);
  EXPECT_DOUBLE_EQ(board->spacing_m, 0.02);
  EXPECT_EQ(boardOf("chessboard:9x6:0.025")->kind, BoardKind::kChessboard);
  EXPECT_EQ(boardOf("circles:6x6:0.034")->kind, BoardKind::kCircles);
}

TEST(Board, WhatIsNoneIsRefused) {
  for (const auto* text : {"", "chessboard", "chessboard:9x6", "squares:9x6:0.025", "chessboard:9:0.025",
                           "chessboard:9x6x2:0.025", "chessboard:2x6:0.025", "chessboard:-9x6:0.025",
                           "chessboard:9x6:0", "chessboard:9x6:-1", "chessboard:9x6:25", "chessboard:9x6:nan",
                           "chessboard:9x99999999999:0.025", "chessboard:9x6:0.025:1"})
    EXPECT_FALSE(boardOf(text)) << text;
}

TEST(Board, PointsLieRowByRow) {
  const auto straight = boardPoints(*boardOf("chessboard:4x3:0.1"));
  ASSERT_EQ(straight.size(), 12u);
  EXPECT_TRUE(straight[5].isApprox(Eigen::Vector3d(0.1, 0.1, 0.0)));
  const auto shifted = boardPoints(*boardOf("asymmetric-circles:4x3:0.1"));
  EXPECT_TRUE(shifted[5].isApprox(Eigen::Vector3d(0.3, 0.1, 0.0)));
  EXPECT_EQ(boardNeighbours(*boardOf("chessboard:4x3:0.1")).size(), 3u * 3u + 4u * 2u);
}

/// A flat picture of a board under an affine map, drawn with 5 x 5 samples a pixel.
struct Drawing {
  Board board;
  Eigen::Matrix2d to_pixels;  ///< steps of the board to pixels
  Eigen::Vector2d first_px;
  bool bright_circles = false;

  [[nodiscard]] Eigen::Vector2d pixelOf(const Eigen::Vector3d& p_M) const {
    return first_px + to_pixels * p_M.head<2>() / board.spacing_m;
  }

  [[nodiscard]] bool isDark(const Eigen::Vector2d& step) const {
    if (board.kind == BoardKind::kChessboard) {
      const bool inside = step.x() > -1 && step.x() < board.columns && step.y() > -1 && step.y() < board.rows;
      return inside &&
             (static_cast<int>(std::floor(step.x())) + static_cast<int>(std::floor(step.y()))) % 2 == 0;
    }
    const int row = static_cast<int>(std::lround(step.y()));
    const bool is_shifted = board.kind == BoardKind::kAsymmetricCircles;
    const int every = is_shifted ? 2 : 1;
    const int shift = is_shifted ? std::abs(row % 2) : 0;
    const int column = static_cast<int>(std::lround((step.x() - shift) / every));
    const bool exists = row >= 0 && row < board.rows && column >= 0 && column < board.columns;
    const Eigen::Vector2d centre(every * column + shift, row);
    if (exists && (centre - step).norm() < 0.3) return !bright_circles;
    return bright_circles;
  }

  [[nodiscard]] std::uint8_t grey(int x, int y, const Eigen::Matrix2d& to_steps) const {
    int light = 0;
    for (int i = 0; i < 25; ++i) {
      const Eigen::Vector2d pixel(x - 0.4 + 0.2 * (i % 5), y - 0.4 + 0.2 * (i / 5));
      light += isDark(to_steps * (pixel - first_px)) ? 30 : 220;
    }
    return static_cast<std::uint8_t>(light / 25);
  }

  [[nodiscard]] camera::GreyImage image() const {
    constexpr int kWidth = 400, kHeight = 300;
    const Eigen::Matrix2d to_steps = to_pixels.inverse();
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) pixels.push_back(grey(x, y, to_steps));
    return {kWidth, kHeight, std::move(pixels)};
  }
};

Eigen::Matrix2d turned(double angle_rad, double step_px) {
  return step_px * Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
}

double worstError_px(const Drawing& drawing, const Sighting& found) {
  double worst = 0.0;
  const auto points = boardPoints(drawing.board);
  for (std::size_t i = 0; i < points.size(); ++i)
    worst = std::max(worst, (found[i].pixel - drawing.pixelOf(points[i])).norm());
  return worst;
}

TEST(BoardFinder, CornersOfAChessboardInOneOrderHoweverItIsHeld) {
  for (const double angle_rad : {0.2, 0.2 + std::numbers::pi}) {
    Drawing drawing{*boardOf("chessboard:7x4:0.025"), turned(angle_rad, 30.0), {}};
    drawing.first_px = Eigen::Vector2d(200, 150) - drawing.to_pixels * Eigen::Vector2d(3.0, 1.5);
    const auto found = findBoard(drawing.image().view(), drawing.board);
    ASSERT_TRUE(found);
    EXPECT_LT(worstError_px(drawing, *found), 0.1) << angle_rad;
  }
}

TEST(BoardFinder, DarkAndBrightCircles) {
  for (const bool bright : {false, true})
    for (const auto* text : {"circles:6x4:0.03", "asymmetric-circles:4x5:0.02"}) {
      Drawing drawing{*boardOf(text), turned(0.15, 30.0), {90.0, 70.0}, bright};
      const auto found = findBoard(drawing.image().view(), drawing.board);
      ASSERT_TRUE(found) << text << bright;
      const auto ordered = orderedLike(*found, *found, drawing.board);
      EXPECT_EQ(ordered, *found);
      std::vector<Eigen::Vector2d> truth;
      for (const auto& p_M : boardPoints(drawing.board)) truth.push_back(drawing.pixelOf(p_M));
      EXPECT_LT(worstError_px(drawing, orderedLike(sightingOf(truth), *found, drawing.board)), 0.2)
          << text << bright;
    }
}

TEST(BoardFinder, OrdersAlikeBoardsAsTheReference) {
  const auto board = *boardOf("circles:4x4:0.03");
  std::vector<Eigen::Vector2d> upright, quarter(16);
  for (const auto& p_M : boardPoints(board)) upright.push_back(1000.0 * p_M.head<2>());
  for (std::size_t i = 0; i < 16; ++i) quarter[4 * (i % 4) + 3 - i / 4] = upright[i];
  const auto wanted = sightingOf(upright);
  EXPECT_EQ(orderedLike(wanted, sightingOf(quarter), board), wanted);
}

TEST(BoardFinder, NothingWhereThereIsNone) {
  const camera::GreyImage grey(64, 48, std::vector<std::uint8_t>(64 * 48, 128));
  const camera::GreyImage tiny(1, 1, {7});
  for (const auto* text : {"chessboard:9x6:0.025", "circles:6x6:0.034", "asymmetric-circles:4x11:0.02"}) {
    EXPECT_FALSE(findBoard(grey.view(), *boardOf(text)));
    EXPECT_FALSE(findBoard(tiny.view(), *boardOf(text)));
  }
}

}  // namespace
}  // namespace mirrorarm::calibration
