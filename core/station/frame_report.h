#pragma once

#include <cstdint>
#include <optional>

#include "core/tracking/teacher.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::station {

/// What control needs to know of one frame. Small and fixed: no image travels to the robot.
struct FrameReport {
  TimePoint exposed_at{};
  std::uint64_t sequence = 0;
  bool has_target = false;         ///< a model is taught
  tracking::TrackedTarget target;  ///< lost while there is no model
  double target_radius_m = 0.0;    ///< of its farthest marker from its origin; 0 while there is no model
  int taught_markers = 0;          ///< while teaching: markers so far
  double taught_sigma_m = 0.0;     ///< while teaching: of the least sure one; infinite while not known
  int teachings = 0;               ///< lessons that ended since the start, well or badly
  std::optional<tracking::TeachingError> teaching_error;  ///< of the last lesson
};

}  // namespace mirrorarm::station
