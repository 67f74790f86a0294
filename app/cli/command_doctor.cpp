#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/machine_check.h"

namespace mirrorarm::cli {
namespace {

void run(Context& context) {
  for (const auto& check : checkMachine()) {
    context.result[check.name] = {{"ok", check.ok}, {"why", check.why}};
    if (!context.json)
      std::cout << (check.ok ? "ok     " : "lacks  ") << check.name << ": " << check.why << "\n";
  }
}

}  // namespace

void addDoctor(CLI::App& app, Context& context) {
  CLI::App* command =
      addCommand(app, context, "doctor", "What this machine has and lacks", "mirrorarm-cli doctor --json");
  command->callback([&context] { run(context); });
}

}  // namespace mirrorarm::cli
