#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

#include "core/common/expected.h"

namespace mirrorarm {

/// Writes `file` whole or not at all: into a neighbour first, renamed when complete. Folders that are missing
/// are made. The error is why it could not be written; nothing half-written is left behind.
[[nodiscard]] Expected<void, std::string> writeWhole(const std::filesystem::path& file,
                                                     const std::function<void(std::ostream&)>& write);

}  // namespace mirrorarm
