#include "app/cli/timing.h"

#include "core/common/quantile.h"

namespace mirrorarm::cli {

nlohmann::ordered_json medianAndP99(const std::vector<double>& durations_ms) {
  if (durations_ms.empty()) return {{"median", nullptr}, {"p99", nullptr}};
  return {{"median", quantile(durations_ms, 0.5)}, {"p99", quantile(durations_ms, 0.99)}};
}

}  // namespace mirrorarm::cli
