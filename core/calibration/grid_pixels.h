#pragma once

#include <map>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace mirrorarm::calibration {

/// A place on a flat grid: column, row.
using Place = Eigen::Vector2i;

/// What the surroundings of a place tell about it.
struct LocalMap {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();         ///< where the image shows the place
  Eigen::Matrix2d steps_px = Eigen::Matrix2d::Identity();  ///< columns: to the next column, to the next row
};

/// Where an image shows the places of a flat grid. Any lens: only neighbours are compared, for which
/// perspective is all that counts.
class GridPixels {
 public:
  static constexpr int kReach = 3;  ///< columns and rows to either side that tell about a place

  void set(const Place& place, const Eigen::Vector2d& pixel) { pixels_[key(place)] = pixel; }
  void erase(const Place& place) { pixels_.erase(key(place)); }
  [[nodiscard]] std::optional<Eigen::Vector2d> at(const Place& place) const;

  /// By perspective and a smooth lens through up to 48 places around it, the place itself left out: right to
  /// about a hundredth of a step. Nothing where fewer than 5 places are near, or all on one line.
  [[nodiscard]] std::optional<LocalMap> around(const Place& place) const;

 private:
  static std::pair<int, int> key(const Place& place) { return {place.y(), place.x()}; }
  std::map<std::pair<int, int>, Eigen::Vector2d> pixels_;
};

}  // namespace mirrorarm::calibration
