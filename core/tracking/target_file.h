#pragma once

#include <filesystem>

#include "core/common/file_error.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

/// Reads `target.yaml` (format mirrorarm/target/1). Refused: unknown keys, fewer than 3 or more than
/// kMaxMarkers markers, markers on one line, two markers closer than their diameter, numbers that are not
/// finite, a name that is empty or would break a table (comma, quotation mark, apostrophe, control
/// character).
[[nodiscard]] FromFile<Target> readTarget(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeTarget(const std::filesystem::path& file,
                                                      const Target& target);

}  // namespace mirrorarm::tracking
