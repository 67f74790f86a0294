#include "core/calibration/capture_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>
#include <opencv2/calib3d.hpp>

#include "core/calibration/board_finder.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestForPose = 4;

/// Corners of the board's outermost points in the image, around it, and its middle.
struct Outline {
  std::array<Eigen::Vector2d, 4> corners;
  Eigen::Vector2d middle;
};

/// By the homography that fits the points seen: hidden ones do not matter.
std::optional<Outline> outlineOf(const Sighting& sighting, const Board& board) {
  if (sighting.size() < kFewestForPose) return std::nullopt;
  const auto points = boardPoints(board);
  std::vector<cv::Point2d> from, to;
  for (const auto& seen : sighting) {
    const Eigen::Vector3d p_M = points[static_cast<std::size_t>(seen.point)] / board.spacing_m;
    from.emplace_back(p_M.x(), p_M.y());
    to.emplace_back(seen.pixel.x(), seen.pixel.y());
  }
  const cv::Mat H = cv::findHomography(from, to);
  if (H.empty()) return std::nullopt;
  const auto pixelOf = [&](double x, double y) {
    const cv::Vec3d p = cv::Matx33d(H) * cv::Vec3d(x, y, 1.0);
    return Eigen::Vector2d(p[0] / p[2], p[1] / p[2]);
  };
  Eigen::Vector3d far = Eigen::Vector3d::Zero();
  for (const auto& p_M : points) far = far.cwiseMax(p_M / board.spacing_m);
  return Outline{{pixelOf(0, 0), pixelOf(far.x(), 0), pixelOf(far.x(), far.y()), pixelOf(0, far.y())},
                 pixelOf(0.5 * far.x(), 0.5 * far.y())};
}

double areaOf(const std::array<Eigen::Vector2d, 4>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

/// 0.5 for two sides alike; more where the first is longer, so nearer.
double tiltOf(const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
  const double ratio = std::log(std::max(first.norm(), 1e-9) / std::max(second.norm(), 1e-9));
  return std::clamp(0.5 + ratio, 0.0, 1.0);
}

double distanceBetween(const ViewSignature& a, const ViewSignature& b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.size - b.size) +
         std::abs(a.tilt_along - b.tilt_along) + std::abs(a.tilt_across - b.tilt_across);
}

/// Mean shift of the points that both show; infinite when none is.
double shiftBetween(const Sighting& before, const Sighting& now) {
  const auto both = seenByBoth({{}, {before, now}});
  if (both.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const auto& [a, b] : both) sum += (b.pixel - a.pixel).norm();
  return sum / static_cast<double>(both.size());
}

}  // namespace

std::string_view id(CaptureVerdict verdict) {
  switch (verdict) {
    case CaptureVerdict::kNoBoard:
      return "no_board";
    case CaptureVerdict::kTooFew:
      return "too_few";
    case CaptureVerdict::kMoving:
      return "moving";
    case CaptureVerdict::kNotNew:
      return "not_new";
    case CaptureVerdict::kTake:
      return "take";
  }
  return "";
}

ViewSignature signatureOf(const Sighting& sighting, const Board& board, ImageSize size) {
  const auto outline = outlineOf(sighting, board);
  if (!outline) return {};
  const auto& [upper_left, upper_right, lower_right, lower_left] = outline->corners;
  const auto share = [](double part, double whole) { return std::clamp(part / whole, 0.0, 1.0); };
  return {share(outline->middle.x(), size.width_px), share(outline->middle.y(), size.height_px),
          std::sqrt(share(areaOf(outline->corners), 1.0 * size.width_px * size.height_px)),
          tiltOf(lower_left - upper_left, lower_right - upper_right),
          tiltOf(upper_right - upper_left, lower_right - lower_left)};
}

CaptureRule::CaptureRule(const Board& board, ImageSize size, bool stereo, const CaptureSettings& settings)
    : board_(board), size_(size), stereo_(stereo), settings_(settings) {}

CaptureVerdict CaptureRule::judge(const BoardView& view, std::span<const BoardView> taken) {
  const std::size_t fewest = std::min(view.seen[0].size(), stereo_ ? view.seen[1].size() : SIZE_MAX);
  const bool is_still = isStill(view);
  if (fewest == 0) return CaptureVerdict::kNoBoard;
  const double wanted = settings_.least_share * board_.columns * board_.rows;
  if (static_cast<double>(fewest) < wanted) return CaptureVerdict::kTooFew;
  if (!is_still) return CaptureVerdict::kMoving;
  return isNew(view, taken) ? CaptureVerdict::kTake : CaptureVerdict::kNotNew;
}

bool CaptureRule::isStill(const BoardView& view) {
  bool is_still = true;
  for (std::size_t camera = 0; camera < (stereo_ ? 2U : 1U); ++camera) {
    const auto& before = last_.seen[camera];
    Sighting now = view.seen[camera];
    if (before.size() == now.size() && !now.empty()) now = orderedLike(before, now, board_);
    is_still = is_still && shiftBetween(before, now) <= settings_.still_px;
    last_.seen[camera] = std::move(now);
  }
  still_frames_ = is_still ? still_frames_ + 1 : 0;
  return still_frames_ >= settings_.still_frames;
}

bool CaptureRule::isNew(const BoardView& view, std::span<const BoardView> taken) const {
  return std::all_of(taken.begin(), taken.end(), [&](const BoardView& other) {
    Sighting now = view.seen[0];
    if (now.size() == other.seen[0].size()) now = orderedLike(other.seen[0], now, board_);
    return distanceBetween(signatureOf(now, board_, size_), signatureOf(other.seen[0], board_, size_)) >=
           settings_.new_distance;
  });
}

}  // namespace mirrorarm::calibration
