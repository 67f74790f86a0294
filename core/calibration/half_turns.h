#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// Stations that show the board half a turn round about its normal, as a finder takes a board whose ends
/// look alike.
struct HalfTurns {
  std::vector<std::size_t> stations;  ///< the smaller part, counted from 0
  /// The far corner of the board, where those stations have their origin. Nothing where no turned station
  /// agrees with the others about it.
  std::optional<Eigen::Vector2d> far_corner_m;
};

/// Told by the angles alone: between a station seen right and one seen half round, robot and camera turn by
/// different angles, and by equal ones once the half turn is undone. The board's size comes from the robot,
/// by the solution of the larger part.
[[nodiscard]] HalfTurns findHalfTurns(std::span<const PosePair> pairs);

/// Turns those stations' object back: its origin is then where the others have it.
void undoHalfTurns(std::span<PosePair> pairs, const HalfTurns& turns);

}  // namespace mirrorarm::calibration
