#include "app/cli/timing.h"

#include <algorithm>

namespace mirrorarm::cli {

nlohmann::ordered_json medianAndP99(std::vector<double> durations_ms) {
  if (durations_ms.empty()) return {{"median", nullptr}, {"p99", nullptr}};
  std::sort(durations_ms.begin(), durations_ms.end());
  const std::size_t last = durations_ms.size() - 1;
  return {{"median", durations_ms[last / 2]}, {"p99", durations_ms[last * 99 / 100]}};
}

}  // namespace mirrorarm::cli
