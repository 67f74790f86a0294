#include "core/calibration/board_finder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace mirrorarm::calibration {
namespace {

constexpr int kLargestHalfWindow_px = 11;
/// Of the closest corners' distance. Wider windows reach the smear around the next corner.
constexpr double kHalfWindowShare = 0.3;

using CvPoints = std::vector<cv::Point2f>;
using BoardPixels = std::vector<Eigen::Vector2d>;

std::size_t at(const Board& board, int column, int row) {
  return static_cast<std::size_t>(row * board.columns + column);
}

double closestNeighbours_px(const CvPoints& points, const Board& board) {
  double closest = std::numeric_limits<double>::max();
  for (const auto& [i, j] : boardNeighbours(board))
    closest = std::min(closest, cv::norm(points[i] - points[j]));
  return closest;
}

CvPoints findChessboard(const cv::Mat& grey, const Board& board) {
  CvPoints corners;
  const bool found = cv::findChessboardCorners(grey, {board.columns, board.rows}, corners,
                                               cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE);
  if (!found) return {};
  const int half = std::clamp(static_cast<int>(kHalfWindowShare * closestNeighbours_px(corners, board)), 2,
                              kLargestHalfWindow_px);
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
  return corners;
}

cv::Ptr<cv::FeatureDetector> blobFinder(const cv::Mat& grey) {
  cv::SimpleBlobDetector::Params params;
  params.minArea = 20.0F;
  params.maxArea = static_cast<float>(grey.total()) / 50.0F;
  return cv::SimpleBlobDetector::create(params);
}

CvPoints findDarkCircles(const cv::Mat& grey, const Board& board) {
  CvPoints centres;
  const int flags =
      board.kind == BoardKind::kCircles ? cv::CALIB_CB_SYMMETRIC_GRID : cv::CALIB_CB_ASYMMETRIC_GRID;
  const cv::Size size(board.columns, board.rows);
  return cv::findCirclesGrid(grey, size, centres, flags, blobFinder(grey)) ? centres : CvPoints{};
}

CvPoints findCircles(const cv::Mat& grey, const Board& board) {
  auto centres = findDarkCircles(grey, board);
  return centres.empty() ? findDarkCircles(255 - grey, board) : centres;
}

/// Images too small for the board make OpenCV throw.
CvPoints findPoints(const cv::Mat& grey, const Board& board) {
  if (board.kind == BoardKind::kDotPlate) return {};
  try {
    return board.kind == BoardKind::kChessboard ? findChessboard(grey, board) : findCircles(grey, board);
  } catch (const cv::Exception&) {
    return {};
  }
}

bool isMirrored(const BoardPixels& p, const Board& board) {
  const Eigen::Vector2d along = p[at(board, board.columns - 1, 0)] - p[0];
  const Eigen::Vector2d down = p[at(board, 0, board.rows - 1)] - p[0];
  return along.x() * down.y() - along.y() * down.x() < 0.0;
}

void reverseRows(BoardPixels& p, const Board& board) {
  for (int row = 0; row < board.rows; ++row)
    std::reverse(p.begin() + row * board.columns, p.begin() + (row + 1) * board.columns);
}

/// Grey in the middle of the square that has the corner (column, row) at its upper left.
double greyOfSquare(const camera::ImageView& image, const BoardPixels& p, const Board& board, int column,
                    int row) {
  const Eigen::Vector2d middle = 0.25 * (p[at(board, column, row)] + p[at(board, column + 1, row)] +
                                         p[at(board, column, row + 1)] + p[at(board, column + 1, row + 1)]);
  return image.at(std::clamp(static_cast<int>(std::lround(middle.x())), 0, image.width_px - 1),
                  std::clamp(static_cast<int>(std::lround(middle.y())), 0, image.height_px - 1));
}

bool startsDark(const camera::ImageView& image, const BoardPixels& p, const Board& board) {
  double like_first = 0.0, other = 0.0;
  int likes = 0, others = 0;
  for (int row = 0; row + 1 < board.rows; ++row)
    for (int column = 0; column + 1 < board.columns; ++column) {
      const double grey = greyOfSquare(image, p, board, column, row);
      ((row + column) % 2 == 0 ? like_first : other) += grey;
      ++((row + column) % 2 == 0 ? likes : others);
    }
  return like_first / likes < other / others;
}

/// The board's points after a quarter turn; for as many rows as columns.
BoardPixels quarterTurned(const BoardPixels& p, const Board& board) {
  BoardPixels turned(p.size());
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      turned[at(board, column, row)] = p[at(board, row, board.rows - 1 - column)];
  return turned;
}

std::vector<BoardPixels> alikeOrders(const BoardPixels& p, const Board& board) {
  std::vector<BoardPixels> orders = {p, BoardPixels(p.rbegin(), p.rend())};
  if (board.rows != board.columns || board.kind == BoardKind::kAsymmetricCircles) return orders;
  orders.push_back(quarterTurned(p, board));
  orders.emplace_back(orders[2].rbegin(), orders[2].rend());
  return orders;
}

bool hasOneOrder(const Board& board) {
  if (board.kind == BoardKind::kCircles) return false;
  if (board.kind == BoardKind::kDotPlate) return true;
  return board.kind == BoardKind::kChessboard ? (board.columns + board.rows) % 2 == 1 : board.rows % 2 == 1;
}

Eigen::Vector2d middleOf(const BoardPixels& p) {
  return std::accumulate(p.begin(), p.end(), Eigen::Vector2d(0, 0)) / static_cast<double>(p.size());
}

double disagreement(const BoardPixels& a, const BoardPixels& b) {
  const Eigen::Vector2d shift = middleOf(b) - middleOf(a);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (b[i] - a[i] - shift).squaredNorm();
  return sum;
}

BoardPixels pixelsOf(const Sighting& whole) {
  BoardPixels pixels;
  for (const auto& seen : whole) pixels.push_back(seen.pixel);
  return pixels;
}

}  // namespace

std::string_view reason(BoardMiss miss) {
  return miss == BoardMiss::kNotFound
             ? "the board is not found: check its kind and size, the light, and that nothing covers it"
             : "the pattern goes on beyond the size asked for: give the size of the whole board";
}

Expected<Sighting, BoardMiss> findBoard(const camera::ImageView& image, const Board& board) {
  const cv::Mat grey(image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                     static_cast<std::size_t>(image.stride));
  const auto points = findPoints(grey, board);
  if (points.empty()) return unexpected(BoardMiss::kNotFound);
  BoardPixels pixels;
  for (const auto& point : points) pixels.emplace_back(point.x, point.y);
  if (board.kind != BoardKind::kAsymmetricCircles && isMirrored(pixels, board)) reverseRows(pixels, board);
  if (board.kind == BoardKind::kChessboard && hasOneOrder(board) && !startsDark(image, pixels, board))
    std::reverse(pixels.begin(), pixels.end());
  return sightingOf(pixels);
}

Sighting orderedLike(const Sighting& reference, const Sighting& sighting, const Board& board) {
  assert(reference.size() == sighting.size());
  if (hasOneOrder(board)) return sighting;
  const auto wanted = pixelsOf(reference);
  const auto orders = alikeOrders(pixelsOf(sighting), board);
  return sightingOf(
      *std::min_element(orders.begin(), orders.end(), [&](const BoardPixels& a, const BoardPixels& b) {
        return disagreement(wanted, a) < disagreement(wanted, b);
      }));
}

}  // namespace mirrorarm::calibration
