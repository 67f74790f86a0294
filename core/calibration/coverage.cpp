#include "core/calibration/coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace mirrorarm::calibration {
namespace {

constexpr double kTiltStep_rad = std::numbers::pi / 12.0;

/// Which of `count` even shares of 0..1 holds `share`.
std::optional<std::size_t> binOf(double share, int count) {
  if (!(share >= 0.0 && share <= 1.0)) return std::nullopt;
  return static_cast<std::size_t>(std::min(static_cast<int>(share * count), count - 1));
}

void addPoints(const Sighting& sighting, ImageSize size, Coverage::Grid& grid) {
  for (const auto& seen : sighting) {
    // Pixels reach half a pixel beyond their centres.
    const auto column = binOf((seen.pixel.x() + 0.5) / size.width_px, Coverage::kCells);
    const auto row = binOf((seen.pixel.y() + 0.5) / size.height_px, Coverage::kCells);
    if (column && row) ++grid[*row][*column];
  }
}

template <std::size_t kRows, std::size_t kColumns>
double filledShare(const std::array<std::array<int, kColumns>, kRows>& cells) {
  std::size_t filled = 0;
  for (const auto& row : cells)
    filled += static_cast<std::size_t>(std::count_if(row.begin(), row.end(), [](int n) { return n > 0; }));
  return static_cast<double>(filled) / static_cast<double>(kRows * kColumns);
}

}  // namespace

double Coverage::imageShare(int camera) const {
  return filledShare(image.at(static_cast<std::size_t>(camera)));
}

double Coverage::poseShare() const { return filledShare(pose); }

Coverage coverageOf(std::span<const BoardView> views, std::span<const RigidTransform> X_CM, ImageSize size,
                    const DistanceRange& range, const Eigen::Vector3d& middle_M) {
  Coverage coverage;
  for (const auto& view : views)
    for (std::size_t camera = 0; camera < view.seen.size(); ++camera)
      addPoints(view.seen[camera], size, coverage.image[camera]);
  for (const auto& X : X_CM) {
    const Eigen::Vector3d sight_C = X * middle_M;
    const double distance_m = sight_C.norm();
    const double cosine = std::abs(sight_C.dot(X.linear().col(2))) / distance_m;
    const double tilt_rad = std::acos(std::clamp(cosine, 0.0, 1.0));
    const auto bin =
        binOf((distance_m - range.nearest_m) / (range.farthest_m - range.nearest_m), Coverage::kDistances);
    const auto tilt = std::min(static_cast<int>(tilt_rad / kTiltStep_rad), Coverage::kTilts - 1);
    if (bin) ++coverage.pose[static_cast<std::size_t>(tilt)][*bin];
  }
  return coverage;
}

}  // namespace mirrorarm::calibration
