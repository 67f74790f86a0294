#include <cstdlib>
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/machine_check.h"
#include "core/calibration/validity.h"
#include "core/common/resources.h"

namespace mirrorarm::cli {
namespace {

using calibration::CalibrationKind;
using calibration::Standing;

void tellMachine(Context& context) {
  for (const auto& check : checkMachine()) {
    context.result[check.name] = {{"ok", check.ok}, {"why", check.why}};
    if (!context.json)
      std::cout << (check.ok ? "ok     " : "lacks  ") << check.name << ": " << check.why << "\n";
  }
}

std::string ageOf(const calibration::CalibrationStatus& status) {
  const auto hours = std::chrono::duration_cast<std::chrono::hours>(status.age).count();
  if (status.age < std::chrono::hours(2)) return std::to_string(status.age.count()) + " minutes old";
  return hours < 48 ? std::to_string(hours) + " hours old" : std::to_string(hours / 24) + " days old";
}

std::string lineOf(CalibrationKind kind, const calibration::CalibrationStatus& status) {
  std::string line = std::string(id(kind)) + ": " + std::string(id(status.standing));
  if (status.standing != Standing::kMissing)
    line += ", of " + (status.date.empty() ? "no date" : status.date);
  if (status.age.count() > 0) line += ", " + ageOf(status);
  return line;
}

void tellCalibrations(const std::filesystem::path& path, Context& context) {
  const auto in_force = calibration::CalibrationFolder(path).read();
  if (!in_force) throw InputRefused(describe(in_force.error()));
  const auto validity = validityOf(*in_force, std::chrono::system_clock::now());
  auto& result = context.result["calibrations"];
  result = {{"folder", path.string()}, {"session_allowed", validity.allowsSession()}};
  for (const auto kind : calibration::kCalibrationKinds) {
    const auto& status = validity.of(kind);
    result[std::string(id(kind))] = {{"standing", id(status.standing)},
                                     {"date", status.date},
                                     {"age_hours", static_cast<double>(status.age.count()) / 60.0}};
    if (!context.json)
      std::cout << (status.standing == Standing::kValid ? "ok     " : "check  ") << "calibration "
                << lineOf(kind, status) << "\n";
  }
  if (!context.json)
    std::cout << (validity.allowsSession() ? "ok     calibrations in " : "check  calibrations in ")
              << path.string()
              << (validity.allowsSession() ? ": a session may run\n"
                                           : ": no session with real devices until they are renewed\n");
}

}  // namespace

void addDoctor(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(app, context, "doctor",
                                 "What this machine has and lacks, and which calibrations are in force",
                                 "mirrorarm-cli doctor --json");
  const auto folder = std::make_shared<std::filesystem::path>(dataFolder() / "calibrations");
  command->add_option("--calibrations", *folder, "Folder of the calibrations")->capture_default_str();
  command->callback([folder, &context] {
    tellMachine(context);
    tellCalibrations(*folder, context);
  });
}

}  // namespace mirrorarm::cli
