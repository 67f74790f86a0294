#pragma once

#include <string>

#include "core/experiments/latency.h"

namespace mirrorarm::cli {

/// Draws one move as the paper's figure 7 does, as SVG: the way of the target, of the tool and of the paper's
/// scheme over time, with both beginnings marked.
[[nodiscard]] std::string latencyFigure(const experiments::LatencyResult& result);

/// All moments as CSV: time_s, then x, y, z of target and tool since the start [m].
[[nodiscard]] std::string momentsCsv(const experiments::LatencyResult& result);

}  // namespace mirrorarm::cli
