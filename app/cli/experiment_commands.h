#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "app/cli/command.h"

namespace mirrorarm::cli {

// The subcommands of `experiment`, one a file: app/cli/experiment_<name>.cpp.
void addExperimentAccuracy(CLI::App& experiment, Context& context);
void addExperimentLatency(CLI::App& experiment, Context& context);
void addExperimentOcclusion(CLI::App& experiment, Context& context);
void addExperimentTiming(CLI::App& experiment, Context& context);

/// A further file of an experiment: a figure, raw data.
struct ExperimentFile {
  std::string name;
  std::string content;
};

/// What an experiment found: for programs and as a table for people.
struct ExperimentReport {
  nlohmann::ordered_json result;
  std::string table;
  std::vector<ExperimentFile> files{};
};

/// Adds `experiment <name> --out DIR`, which calls `measure` (throws InputRefused) and writes DIR/<name>.json
/// the table DIR/<name>.md and what files there are, each whole or not at all. Gives the command, for options
/// of its own.
CLI::App* addExperimentCommand(CLI::App& experiment, Context& context, const std::string& name,
                               const std::string& description,
                               const std::function<ExperimentReport()>& measure);

/// `value` with a fixed number of digits, "-" when it is none.
[[nodiscard]] std::string fixedNumber(double value, int digits);

}  // namespace mirrorarm::cli
