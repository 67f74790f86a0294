#include "core/common/resources.h"

#include <cstdlib>
#include <system_error>

namespace mirrorarm {

std::filesystem::path resourceFolder() {
  if (const char* named = std::getenv("MIRRORARM_RESOURCES")) return named;
  std::error_code failed;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
  const auto installed = program.parent_path().parent_path() / "share/mirrorarm/resources";
  if (!failed && std::filesystem::is_directory(installed, failed)) return installed;
  return MIRRORARM_SOURCE_RESOURCES;
}

std::filesystem::path dataFolder() {
  if (const char* named = std::getenv("MIRRORARM_DATA")) return named;
  if (const char* shared = std::getenv("XDG_DATA_HOME")) return std::filesystem::path(shared) / "mirrorarm";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / ".local/share/mirrorarm";
}

}  // namespace mirrorarm
