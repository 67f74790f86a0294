#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::calibration {

struct ImageSize {
  int width_px = 0;
  int height_px = 0;
  bool operator==(const ImageSize&) const = default;
};

/// One point of a board as one raw image shows it.
struct SeenPoint {
  int point = 0;  ///< index into boardPoints()
  Eigen::Vector2d pixel =
      Eigen::Vector2d::Zero();  ///< the corner; of a disc the centre of its fitted outline
  double sigma_px = 0.0;        ///< standard deviation along either axis; 0 where unknown
  /// Shape matrix of a disc's outline (see vision::shapeOf); zero for a corner. With the board's pose it
  /// tells how far the outline's centre lies from the image of the disc's own centre.
  Eigen::Matrix2d shape_px2 = Eigen::Matrix2d::Zero();
  bool operator==(const SeenPoint&) const = default;
};

/// The points of a board that one image shows, ascending by index, each once. Some may be hidden.
using Sighting = std::vector<SeenPoint>;

/// All points of a board in their order, from their pixels alone.
[[nodiscard]] Sighting sightingOf(std::span<const Eigen::Vector2d> pixels);

/// One standstill of the board, seen by the first camera and, in a rig, by the second at the same moment.
struct BoardView {
  std::string name;              ///< of the first camera's image
  std::array<Sighting, 2> seen;  ///< a camera each; the second is empty for a single camera
};

/// The points that both images of a view show: first and second camera's.
[[nodiscard]] std::vector<std::pair<SeenPoint, SeenPoint>> seenByBoth(const BoardView& view);

}  // namespace mirrorarm::calibration
