#include "core/calibration/disc_bias.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/LU>

#include "core/calibration/median.h"
#include "core/vision/centre_correction.h"

namespace mirrorarm::calibration {
namespace {

/// Radii that differ by more are sizes of their own.
constexpr double kLikeSize = 1.2;

/// Radius of the disc whose outline has the area seen: the board's plane and the image differ there by an
/// affine map.
std::optional<double> radius_m(const PosedSighting& image, const Eigen::Vector3d& p_M,
                               const SeenPoint& seen) {
  const double spread_px4 = seen.shape_px2.determinant();
  if (!(spread_px4 > 0.0)) return std::nullopt;
  camera::CameraModel::ProjectJacobian by_point;
  if (!image.camera.project(image.X_KM * p_M, by_point)) return std::nullopt;
  const Eigen::Matrix2d by_plane = by_point * image.X_KM.linear().leftCols<2>();
  const double radius = std::sqrt(std::sqrt(spread_px4) / std::abs(by_plane.determinant()));
  return std::isfinite(radius) ? std::optional(radius) : std::nullopt;
}

/// Gives every radius the median of those of like size.
void shareSizes(std::vector<double>& radii) {
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return radii[i] <= 0.0; });
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return radii[a] < radii[b]; });
  for (auto first = order.begin(); first != order.end();) {
    auto last = first + 1;
    while (last != order.end() && radii[*last] <= kLikeSize * radii[*(last - 1)]) ++last;
    const double middle = radii[*(first + (last - first) / 2)];
    std::for_each(first, last, [&](std::size_t i) { radii[i] = middle; });
    first = last;
  }
}

}  // namespace

std::vector<double> discRadii(std::span<const Eigen::Vector3d> board, std::span<const PosedSighting> images) {
  std::vector<std::vector<double>> found(board.size());
  for (const auto& image : images)
    for (const auto& seen : image.sighting) {
      const auto point = static_cast<std::size_t>(seen.point);
      if (const auto radius = radius_m(image, board[point], seen)) found[point].push_back(*radius);
    }
  std::vector<double> radii(board.size(), 0.0);
  for (std::size_t i = 0; i < board.size(); ++i)
    if (!found[i].empty()) radii[i] = median(std::move(found[i]));
  shareSizes(radii);
  return radii;
}

Sighting physicalCentres(const PosedSighting& image, std::span<const Eigen::Vector3d> board,
                         std::span<const double> radii_m) {
  Sighting corrected = image.sighting;
  for (auto& seen : corrected) {
    const auto point = static_cast<std::size_t>(seen.point);
    if (radii_m[point] <= 0.0 || seen.shape_px2.isZero()) continue;
    const vision::FlatDisc disc{image.X_KM * board[point], -image.X_KM.linear().col(2), radii_m[point]};
    seen.pixel = vision::physicalCentre(image.camera, seen.pixel, disc);
  }
  return corrected;
}

}  // namespace mirrorarm::calibration
