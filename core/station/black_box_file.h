#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/common/expected.h"
#include "core/control/servo_loop.h"

namespace mirrorarm::station {

/// A file of its own for the black box of a stop that is kept now: "stop-<time>-<reason>.csv" in `folder`,
/// with "-2", "-3".. where one of that name is there already.
[[nodiscard]] std::filesystem::path blackBoxFile(const std::filesystem::path& folder,
                                                 control::StopReason reason);

/// Writes the servo cycles around a stop as CSV, a row a cycle: what supervisor, guard and operator said,
/// the ages of the news, force and help, then measured, commanded and sent joints. Columns:
/// docs/formats-own.md. Whole or not at all; the error is the reason.
[[nodiscard]] Expected<void, std::string> writeBlackBox(const std::filesystem::path& file,
                                                        std::span<const control::ServoState> states);

}  // namespace mirrorarm::station
