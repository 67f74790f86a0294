#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::benchmarks::vision {

/// A node of a quadrature around a closed curve: the sum of f(x, y) dy over all nodes is the integral of f dy
/// once around, counter-clockwise from x to y. Pieces of at most a pixel with four Gauss-Legendre nodes each
/// integrate a point spread of half a pixel and more to 1e-7.
struct OutlineNode {
  double x = 0.0, y = 0.0, dy = 0.0;
};
using Outline = std::vector<OutlineNode>;

/// Straight edge of an occluder over the ellipse centre + axes * u, |u| <= 1: what lies at
/// u . (cos direction, sin direction) > limit is covered.
struct Cut {
  double direction_rad = 0.0;
  double limit = 1.0;  ///< -1 all covered, 1 nothing
};

/// The cut that covers `share` 0..1 of the area, whatever the ellipse: an affine map keeps shares.
[[nodiscard]] Cut cutOfArea(double share, double direction_rad);

/// `axes` has a positive determinant.
[[nodiscard]] Outline ellipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes);
[[nodiscard]] Outline cutEllipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes,
                                        const Cut& cut);
/// Corners in the order from x to y.
[[nodiscard]] Outline polygonOutline(std::span<const Eigen::Vector2d> corners);

}  // namespace mirrorarm::benchmarks::vision
