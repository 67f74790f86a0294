#pragma once

#include <vector>

#include <nlohmann/json.hpp>

namespace mirrorarm::cli {

/// {"median": .., "p99": ..} of durations; null for both when there are none.
[[nodiscard]] nlohmann::ordered_json medianAndP99(const std::vector<double>& durations_ms);

}  // namespace mirrorarm::cli
