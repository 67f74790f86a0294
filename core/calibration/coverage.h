#pragma once

#include <array>
#include <span>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// Where the points of the views so far lie, for the operator's eye and as figures.
struct Coverage {
  static constexpr int kCells = 10;     ///< along each side of the image, as OpenCV's interactive calibration
  static constexpr int kTilts = 4;      ///< 0-15, 15-30, 30-45, 45 degrees and more
  static constexpr int kDistances = 4;  ///< even shares of the distances asked for
  using Grid = std::array<std::array<int, kCells>, kCells>;  ///< points in [row][column]

  std::array<Grid, 2> image{};                             ///< a camera each
  std::array<std::array<int, kDistances>, kTilts> pose{};  ///< views in [tilt][distance]

  /// Share of an image's cells that hold a point, 0..1.
  [[nodiscard]] double imageShare(int camera) const;
  /// Share of the tilts and distances that hold a view, 0..1.
  [[nodiscard]] double poseShare() const;
};

/// Distances of a board that a view may have [m].
struct DistanceRange {
  double nearest_m = 0.25;
  double farthest_m = 0.65;
};

/// `X_CM`: the board in the first camera as far as it is known, a view each; empty when it is not. Tilt is
/// the angle between the board's normal and the line of sight to `middle_M` (see boardMiddle()), distance the
/// way to it; views nearer or farther than `range` are in no cell.
[[nodiscard]] Coverage coverageOf(std::span<const BoardView> views, std::span<const RigidTransform> X_CM,
                                  ImageSize size, const DistanceRange& range = {},
                                  const Eigen::Vector3d& middle_M = Eigen::Vector3d::Zero());

}  // namespace mirrorarm::calibration
