#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/experiment_commands.h"
#include "core/common/atomic_file.h"

namespace mirrorarm::cli {

void writeExperiment(const std::filesystem::path& folder, const std::string& name,
                     const nlohmann::ordered_json& result, const std::string& table) {
  orFail(writeWhole(folder / (name + ".json"), [&](std::ostream& out) { out << result.dump(2) << "\n"; }));
  orFail(writeWhole(folder / (name + ".md"), [&](std::ostream& out) { out << table; }));
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
  addExperimentOcclusion(*command, context);
  addExperimentTiming(*command, context);
}

}  // namespace mirrorarm::cli
