#include <iostream>

#include <CLI/CLI.hpp>

#include "benchmarks/suite.h"

namespace {

using namespace mirrorarm::benchmarks;

void addSuite(CLI::App& app, const Suite& suite, RunOptions& options) {
  CLI::App* command = app.add_subcommand(std::string(suite.name), std::string(suite.what));
  command->add_option("--out", options.out, "Folder for the reports and pictures")
      ->capture_default_str()
      ->take_last();
  command->add_flag("--quick", options.quick, "Few trials: shows that it runs, not how well");
  std::string names;
  for (const Scenario& scenario : suite.scenarios) names += " " + std::string(scenario.name);
  command->add_option("--only", options.only, "Scenarios to run, of" + names);
  command->callback([&] {
    std::filesystem::create_directories(options.out);
    const Report report = runSuite(suite, options);
    std::cout << toMarkdown(report);
    if (const auto written = writeReport(options.out, report); !written)
      throw std::runtime_error(written.error());
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measures mirrorarm against its goals and against other methods", "mirrorarm-benchmark"};
  app.set_version_flag("--version", MIRRORARM_VERSION);
  app.require_subcommand(1);
  RunOptions options{"build/benchmarks", false, {}};
  const auto all = suites();
  for (const Suite& suite : all) addSuite(app, suite, options);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& failure) {
    std::cerr << "mirrorarm-benchmark: " << failure.what() << "\n";
    return 1;
  }
}
