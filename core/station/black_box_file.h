#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/common/expected.h"
#include "core/control/servo_loop.h"

namespace mirrorarm::station {

/// Writes the servo cycles before a stop as CSV: a row a cycle with measured and commanded joints, what the
/// guard and the supervisor said. The error is the reason.
[[nodiscard]] Expected<void, std::string> writeBlackBox(const std::filesystem::path& file,
                                                        std::span<const control::ServoState> states);

}  // namespace mirrorarm::station
