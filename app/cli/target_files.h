#pragma once

#include <filesystem>
#include <vector>

#include "core/tracking/target.h"

namespace mirrorarm::cli {

/// The targets of --target, each of a name of its own; throws InputRefused.
[[nodiscard]] std::vector<tracking::Target> readTargets(const std::vector<std::filesystem::path>& files);

}  // namespace mirrorarm::cli
