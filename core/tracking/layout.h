#pragma once

#include <span>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// Markers that lie nearer than this to one line (root mean square) do not fix a turn about it.
inline constexpr double kLineWidth_m = 0.002;

/// True when the points lie on one line to within kLineWidth_m; fewer than 3 points always do.
[[nodiscard]] bool areCollinear(std::span<const Eigen::Vector3d> points);

/// Smallest distance between two of the points [m]; infinite below two points.
[[nodiscard]] double smallestDistance(std::span<const Eigen::Vector3d> points);

}  // namespace mirrorarm::tracking
