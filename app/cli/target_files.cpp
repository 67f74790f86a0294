#include "app/cli/target_files.h"

#include <algorithm>

#include "app/cli/command.h"
#include "core/tracking/target_file.h"

namespace mirrorarm::cli {

using tracking::Target;

std::vector<Target> readTargets(const std::vector<std::filesystem::path>& files) {
  std::vector<Target> targets;
  for (const auto& file : files) {
    Target target = orRefuse(tracking::readTarget(file));
    const bool twice = std::any_of(targets.begin(), targets.end(),
                                   [&target](const Target& other) { return other.name == target.name; });
    if (twice)
      throw InputRefused(file.string() + ": name '" + target.name + "' is that of another target already");
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace mirrorarm::cli
