#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/tracking/arm_joints.h"
#include "core/tracking/pose_file.h"

namespace mirrorarm::tracking {

/// The arm's angles in one frame: tracked when all its targets were, predicted when one of them was, lost
/// when one was lost.
struct AngleRow {
  long long index = 0;
  TimePoint exposed_at{};
  TrackStatus status = TrackStatus::kLost;
  ArmAngles angles;  ///< good unless lost
};

/// The angles of every frame that the poses speak of, which come frame by frame.
[[nodiscard]] std::vector<AngleRow> angleRows(const ArmModel& model, std::span<const PoseRow> poses);

/// Writes angles.csv, a row a frame, numbers empty when lost; whole or not at all. Angles and their standard
/// deviations in radians; *_singular are 0 or 1.
[[nodiscard]] Expected<void, std::string> writeAngles(const std::filesystem::path& file,
                                                      std::span<const AngleRow> rows);

}  // namespace mirrorarm::tracking
