#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::vision {

/// A dot's place on a plate: column, row.
using Place = Eigen::Vector2i;

/// The dots of a regular plate put in order, starting from the middle and going on from neighbour to
/// neighbour. Place {0, 0} is the dot at the lowest column and row that was reached.
class PlateLattice {
 public:
  explicit PlateLattice(const std::vector<Eigen::Vector2d>& dots);

  /// Where a dot belongs, in the order of the dots; nothing for dots that the lattice does not reach.
  [[nodiscard]] const std::vector<std::optional<Place>>& places() const { return places_; }
  /// Columns and rows.
  [[nodiscard]] Eigen::Vector2i size() const { return size_; }

 private:
  struct Basis {
    std::array<Eigen::Vector2d, 2> step;  ///< to the next column, to the next row
  };
  [[nodiscard]] std::optional<std::size_t> nearest(const Eigen::Vector2d& to, double within) const;
  [[nodiscard]] Basis basisAt(std::size_t dot) const;
  void grow(std::size_t start);

  std::vector<Eigen::Vector2d> dots_;
  std::vector<std::optional<Place>> places_;
  Eigen::Vector2i size_ = Eigen::Vector2i::Zero();
};

/// The homography from places to points, least squares after scaling (Hartley and Zisserman, 4.4).
[[nodiscard]] Eigen::Matrix3d homographyOf(const std::vector<Place>& places,
                                           const std::vector<Eigen::Vector2d>& points);

}  // namespace mirrorarm::vision
