#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::therapy {

/// Two paths recorded at the same times: where the end effector belonged and where it was [m, robot base].
struct PathPair {
  std::vector<double> time_s;  ///< increasing
  std::vector<Eigen::Vector3d> goal;
  std::vector<Eigen::Vector3d> reached;
};

/// Delays that are looked for [s].
inline constexpr double kLeastLag_s = -0.1, kLargestLag_s = 1.5;

/// The delay [s] of the reached paths against the goals' that leaves the least rms distance between them.
///
/// The paths are resampled evenly at their own median interval and shifted by whole steps, so that the noise
/// weighs the same in every shift; a parabola through the best three gives the fraction. Every shift is
/// judged over the same instants. Nothing when no piece is longer than about 2 s, when the goals hardly move
/// (2 mm rms), when the best delay lies at the end of the range, or above 500 samples a second.
[[nodiscard]] std::optional<double> lagOf(std::span<const PathPair> pieces);

/// The path at `time`, on the straight line between its neighbours. `time` is held inside the path's own
/// times.
[[nodiscard]] Eigen::Vector3d pointAt(std::span<const double> time_s, std::span<const Eigen::Vector3d> path,
                                      double time);

}  // namespace mirrorarm::therapy
