#pragma once

#include <CLI/App.hpp>

#include "core/tracking/tracker.h"

namespace mirrorarm::cli {

/// Adds --tracker: how targets are found and followed, checked against the methods there are.
CLI::Option* addTrackerOption(CLI::App& command, tracking::TrackingMethod& method);

}  // namespace mirrorarm::cli
