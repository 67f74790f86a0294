#pragma once

#include <filesystem>
#include <string_view>

namespace mirrorarm {

enum class LogLevel { kInfo, kWarning, kError };

/// Writes one line to standard error and, once opened, to the log file. Any thread; never call it from the
/// servo step or the per-frame path.
void log(LogLevel level, std::string_view message);

/// From now on also appends to `file`. Call once, before threads start.
void openLogFile(const std::filesystem::path& file);

}  // namespace mirrorarm
