#pragma once

#include <CLI/App.hpp>

#include "app/cli/command.h"

namespace mirrorarm::cli {

// One a file: app/cli/command_<name>.cpp. Each adds its subcommand; its callback runs while parsing.
void addArm(CLI::App& app, Context& context);
void addCalibrate(CLI::App& app, Context& context);
void addDetect(CLI::App& app, Context& context);
void addDoctor(CLI::App& app, Context& context);
void addExperiment(CLI::App& app, Context& context);
void addListen(CLI::App& app, Context& context);
void addServe(CLI::App& app, Context& context);
void addSession(CLI::App& app, Context& context);
void addSimulate(CLI::App& app, Context& context);
void addTarget(CLI::App& app, Context& context);
void addTeach(CLI::App& app, Context& context);
void addTrack(CLI::App& app, Context& context);

}  // namespace mirrorarm::cli
