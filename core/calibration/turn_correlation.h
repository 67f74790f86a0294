#pragma once

#include "core/calibration/timed_path.h"

namespace mirrorarm::calibration {

/// The offset at which two streams of one rigid body turn most alike.
struct TurnCorrelation {
  double offset_s = 0.0;         ///< added to the camera's time it gives the robot's
  double correlation = 0.0;      ///< of both angular speeds there, -1..1
  double rival = 0.0;            ///< the best one at an offset that is not the same peak
  double common_s = 0.0;         ///< time that both streams cover, without gaps
  double speed_std_rad_s = 0.0;  ///< how much the robot's angular speed changes
};

/// Angular speeds, which do not depend on where the camera sits, on a common grid; every offset of the grid
/// within `search_s` is tried, the best refined by a parabola.
[[nodiscard]] TurnCorrelation correlateTurns(const TimedPath& robot, const TimedPath& camera,
                                             double search_s);

}  // namespace mirrorarm::calibration
