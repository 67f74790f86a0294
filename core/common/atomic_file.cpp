#include "core/common/atomic_file.h"

#include <fstream>
#include <limits>
#include <system_error>
#include <unistd.h>

namespace mirrorarm {

Expected<void, std::string> writeWhole(const std::filesystem::path& file,
                                       const std::function<void(std::ostream&)>& write) {
  std::error_code failed;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
  auto neighbour = file;
  neighbour += ".part" + std::to_string(::getpid());
  {
    std::ofstream out(neighbour, std::ios::binary | std::ios::trunc);
    out.precision(std::numeric_limits<double>::max_digits10);
    if (out) write(out);
    out.close();
    if (!out) {
      std::filesystem::remove(neighbour, failed);
      return unexpected(file.string() + ": cannot be written");
    }
  }
  std::filesystem::rename(neighbour, file, failed);
  if (!failed) return {};
  const std::string reason = file.string() + ": " + failed.message();
  std::filesystem::remove(neighbour, failed);
  return unexpected(reason);
}

}  // namespace mirrorarm
