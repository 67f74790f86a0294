#include <csignal>

#include "app/cli/commands.h"
#include "app/cli/serve_commands.h"

namespace mirrorarm::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void catchInterrupt() {
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
}

bool isInterrupted() { return interrupted != 0; }

void addServe(CLI::App& app, Context& context) {
  CLI::App* serve = app.add_subcommand("serve", "Lend a device of this host to another one");
  serve->require_subcommand(1);
  addServeRobot(*serve, context);
  addServeTracking(*serve, context);
}

}  // namespace mirrorarm::cli
