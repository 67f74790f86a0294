#pragma once

#include <filesystem>

namespace mirrorarm {

/// The folder with robots, rigs, scenes: the environment variable MIRRORARM_RESOURCES, else the one installed
/// beside the program (../share/mirrorarm/resources), else the one of the source tree it was built from.
[[nodiscard]] std::filesystem::path resourceFolder();

/// The folder of this user's records and calibrations: the environment variable MIRRORARM_DATA, else
/// mirrorarm in XDG_DATA_HOME, else ~/.local/share/mirrorarm. It may not be there yet.
[[nodiscard]] std::filesystem::path dataFolder();

}  // namespace mirrorarm
