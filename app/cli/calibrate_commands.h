#pragma once

#include <CLI/App.hpp>

#include "app/cli/command.h"

namespace mirrorarm::cli {

/// The commands under `calibrate`.
void addCalibrateHandEye(CLI::App& calibrate, Context& context);

}  // namespace mirrorarm::cli
