#pragma once

#include <filesystem>

#include <CLI/App.hpp>

#include "app/cli/command.h"

namespace mirrorarm::cli {

// The subcommands of `experiment`, one a file: app/cli/experiment_<name>.cpp.
void addExperimentOcclusion(CLI::App& experiment, Context& context);
void addExperimentTiming(CLI::App& experiment, Context& context);

/// Writes `<name>.json` and the table `<name>.md` into `folder`, each whole or not at all.
void writeExperiment(const std::filesystem::path& folder, const std::string& name,
                     const nlohmann::ordered_json& result, const std::string& table);

/// `value` with a fixed number of digits, "-" when it is none.
[[nodiscard]] std::string fixedNumber(double value, int digits);

}  // namespace mirrorarm::cli
