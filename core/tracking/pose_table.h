#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/common/file_error.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// The targets that were tracked in one frame, by name: X_CT.
using TrackedPoses = std::map<std::string, RigidTransform, std::less<>>;

/// Reads poses.csv as `writePoses` makes it, frame by frame in its order; rows that are not `tracked` say
/// nothing. Refused with the line: columns missing, an index that falls, a status that is none, numbers that
/// are not finite, a quaternion that is none, a target twice in one frame.
[[nodiscard]] FromFile<std::vector<TrackedPoses>> readTrackedPoses(const std::filesystem::path& file);

}  // namespace mirrorarm::tracking
