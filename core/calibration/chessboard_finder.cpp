#include "core/calibration/chessboard_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/calibration/corner_grid.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kLargestHalfWindow_px = 11;
/// Of the closest corners' distance. Wider windows reach the smear around the next corner.
constexpr double kHalfWindowShare = 0.3;
/// Parts of a board from which it is sought when it is not found in the size asked for.
constexpr int kSeedColumns = 6, kSeedRows = 4;

using CvPoints = std::vector<cv::Point2f>;
using BoardPixels = std::vector<Eigen::Vector2d>;

/// Corners row by row.
struct Corners {
  int columns = 0, rows = 0;
  BoardPixels pixels;

  [[nodiscard]] const Eigen::Vector2d& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row * columns + column)];
  }
};

cv::Mat matOf(const camera::ImageView& image) {
  return {image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.data),
          static_cast<std::size_t>(image.stride)};
}

double closestNeighbours_px(const CvPoints& points, const cv::Size& size) {
  double closest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto columns = static_cast<std::size_t>(size.width);
    if ((i + 1) % columns != 0) closest = std::min(closest, cv::norm(points[i] - points[i + 1]));
    if (i + columns < points.size()) closest = std::min(closest, cv::norm(points[i] - points[i + columns]));
  }
  return closest;
}

Corners transposed(const Corners& corners) {
  Corners turned{corners.rows, corners.columns, {}};
  for (int row = 0; row < turned.rows; ++row)
    for (int column = 0; column < turned.columns; ++column) turned.pixels.push_back(corners.at(row, column));
  return turned;
}

Corners refined(const cv::Mat& grey, CvPoints points, const cv::Size& size) {
  const int half = std::clamp(static_cast<int>(kHalfWindowShare * closestNeighbours_px(points, size)), 2,
                              kLargestHalfWindow_px);
  cv::cornerSubPix(grey, points, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
  Corners corners{size.width, size.height, {}};
  for (const auto& point : points) corners.pixels.emplace_back(point.x, point.y);
  return corners;
}

std::optional<Corners> findWished(const cv::Mat& grey, const Board& board) {
  CvPoints points;
  const cv::Size size(board.columns, board.rows);
  // Without that the search takes minutes where an image is full of other things.
  if (!cv::checkChessboard(grey, size)) return std::nullopt;
  const bool found = cv::findChessboardCorners(grey, size, points,
                                               cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE);
  return found ? std::optional(refined(grey, points, size)) : std::nullopt;
}

/// As much of a chessboard of any size as can be found from a part of it.
std::optional<Corners> findAny(const cv::Mat& grey, const Board& board) {
  const cv::Size seed(std::min(board.columns, kSeedColumns), std::min(board.rows, kSeedRows));
  CvPoints points;
  cv::Mat squares;
  if (!cv::findChessboardCornersSB(grey, seed, points, cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_LARGER,
                                   squares))
    return std::nullopt;
  const Corners corners = refined(grey, points, squares.size());
  return corners.columns == board.rows ? transposed(corners) : corners;
}

bool isLarger(const Corners& corners, const Board& board) {
  const auto [shorter, longer] = std::minmax(corners.columns, corners.rows);
  const auto [wished_shorter, wished_longer] = std::minmax(board.columns, board.rows);
  return shorter >= wished_shorter && longer >= wished_longer &&
         shorter + longer > board.columns + board.rows;
}

bool isMirrored(const Corners& corners) {
  const Eigen::Vector2d along = corners.at(corners.columns - 1, 0) - corners.at(0, 0);
  const Eigen::Vector2d down = corners.at(0, corners.rows - 1) - corners.at(0, 0);
  return along.x() * down.y() - along.y() * down.x() < 0.0;
}

void reverseRows(Corners& corners) {
  for (int row = 0; row < corners.rows; ++row) {
    const auto begin = corners.pixels.begin() + row * corners.columns;
    std::reverse(begin, begin + corners.columns);
  }
}

/// Grey in the middle of the square that has the corner (column, row) at its upper left.
double greyOfSquare(const camera::ImageView& image, const Corners& corners, int column, int row) {
  const Eigen::Vector2d middle = 0.25 * (corners.at(column, row) + corners.at(column + 1, row) +
                                         corners.at(column, row + 1) + corners.at(column + 1, row + 1));
  return image.at(std::clamp(static_cast<int>(std::lround(middle.x())), 0, image.width_px - 1),
                  std::clamp(static_cast<int>(std::lround(middle.y())), 0, image.height_px - 1));
}

bool startsDark(const camera::ImageView& image, const Corners& corners) {
  double like_first = 0.0, other = 0.0;
  int likes = 0, others = 0;
  for (int row = 0; row + 1 < corners.rows; ++row)
    for (int column = 0; column + 1 < corners.columns; ++column) {
      const double grey = greyOfSquare(image, corners, column, row);
      ((row + column) % 2 == 0 ? like_first : other) += grey;
      ++((row + column) % 2 == 0 ? likes : others);
    }
  return like_first / likes < other / others;
}

Expected<Corners, BoardMiss> findCorners(const camera::ImageView& image, const Board& board) {
  const cv::Mat grey = matOf(image);
  for (const auto find : {findWished, findAny}) {
    const auto corners = find(grey, board);
    if (!corners) continue;
    const CornerGrid grid(image, corners->pixels, corners->columns);
    if (!grid.isChessboard()) continue;
    if (isLarger(*corners, board)) return unexpected(BoardMiss::kLargerBoard);
    if (corners->columns != board.columns || corners->rows != board.rows) continue;
    if (grid.goesOn()) return unexpected(BoardMiss::kLargerBoard);
    return *corners;
  }
  return unexpected(BoardMiss::kNotFound);
}

}  // namespace

Expected<Sighting, BoardMiss> findChessboard(const camera::ImageView& image, const Board& board) {
  auto corners = [&]() -> Expected<Corners, BoardMiss> {
    try {
      return findCorners(image, board);
    } catch (const cv::Exception&) {  // images too small for the board
      return unexpected(BoardMiss::kNotFound);
    }
  }();
  if (!corners) return unexpected(corners.error());
  if (isMirrored(*corners)) reverseRows(*corners);
  const bool has_one_order = (board.columns + board.rows) % 2 == 1;
  if (has_one_order && !startsDark(image, *corners))
    std::reverse(corners->pixels.begin(), corners->pixels.end());
  return sightingOf(corners->pixels);
}

}  // namespace mirrorarm::calibration
