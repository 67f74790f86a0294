#pragma once

#include <CLI/App.hpp>

#include "app/cli/command.h"

namespace mirrorarm::cli {

/// The commands under `serve`.
void addServeRobot(CLI::App& serve, Context& context);
void addServeTracking(CLI::App& serve, Context& context);

/// From now on Ctrl-C and SIGTERM are left to the command, which looks whether one came.
void catchInterrupt();
[[nodiscard]] bool isInterrupted();

}  // namespace mirrorarm::cli
