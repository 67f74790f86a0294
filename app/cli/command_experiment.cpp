#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/experiment_commands.h"
#include "core/common/atomic_file.h"

namespace mirrorarm::cli {

CLI::App* addExperimentCommand(CLI::App& experiment, Context& context, const std::string& name,
                               const std::string& description,
                               const std::function<ExperimentReport()>& measure) {
  CLI::App* command = addCommand(experiment, context, name, description,
                                 "mirrorarm-cli experiment " + name + " --out results");
  const auto out = std::make_shared<std::filesystem::path>();
  command->add_option("--out", *out, "Folder for the table and its JSON")->required();
  command->callback([name, measure, out, &context] {
    const ExperimentReport report = measure();
    context.result = report.result;
    orFail(writeWhole(*out / (name + ".json"),
                      [&](std::ostream& file) { file << report.result.dump(2) << "\n"; }));
    orFail(writeWhole(*out / (name + ".md"), [&](std::ostream& file) { file << report.table; }));
    for (const ExperimentFile& each : report.files)
      orFail(writeWhole(*out / each.name, [&](std::ostream& file) { file << each.content; }));
    if (!context.json) std::cout << report.table;
  });
  return command;
}

std::string fixedNumber(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

void addExperiment(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("experiment", "Repeat the paper's experiments beside its figures");
  command->require_subcommand(1);
  addExperimentAccuracy(*command, context);
  addExperimentLatency(*command, context);
  addExperimentOcclusion(*command, context);
  addExperimentTiming(*command, context);
}

}  // namespace mirrorarm::cli
