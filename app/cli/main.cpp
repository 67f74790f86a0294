#include <iostream>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"

namespace {

constexpr int kDone = 0, kFailed = 1, kWrongUse = 2;

/// Errors of the command line come from CLI11; --help and --version leave as "errors" with code 0.
int tell(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::cerr << "mirrorarm-cli: " << error.what() << " (--help shows how)\n";
  return kWrongUse;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace mirrorarm::cli;
  CLI::App app{"mirrorarm: every job of the pipeline from a terminal", "mirrorarm-cli"};
  app.set_version_flag("--version", MIRRORARM_VERSION);
  app.require_subcommand(1);
  Context context;
  addArm(app, context);
  addCalibrate(app, context);
  addDetect(app, context);
  addDoctor(app, context);
  addExperiment(app, context);
  addListen(app, context);
  addServe(app, context);
  addSession(app, context);
  addSimulate(app, context);
  addTarget(app, context);
  addTeach(app, context);
  addTrack(app, context);
  try {
    app.parse(argc, argv);
    if (context.json) std::cout << context.result.dump() << std::endl;
    return kDone;
  } catch (const CLI::ParseError& error) {
    return tell(app, error);
  } catch (const InputRefused& refusal) {
    std::cerr << "mirrorarm-cli: " << refusal.what() << "\n";
    return kWrongUse;
  } catch (const std::exception& failure) {
    std::cerr << "mirrorarm-cli: " << failure.what() << "\n";
    return kFailed;
  }
}
