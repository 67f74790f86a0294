#pragma once

#include <filesystem>

namespace mirrorarm {

/// The folder with robots, rigs, scenes: the environment variable MIRRORARM_RESOURCES, else the one installed
/// beside the program (../share/mirrorarm/resources), else the one of the source tree it was built from.
[[nodiscard]] std::filesystem::path resourceFolder();

}  // namespace mirrorarm
