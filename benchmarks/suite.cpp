#include "benchmarks/suite.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "benchmarks/calibration/suite.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/tracking/suite.h"
#include "benchmarks/vision/suite.h"
#include "core/common/time.h"

namespace mirrorarm::benchmarks {
namespace {

void refuseUnknown(const Suite& suite, const RunOptions& options) {
  for (const auto& name : options.only)
    if (std::ranges::none_of(suite.scenarios, [&](const Scenario& each) { return each.name == name; }))
      throw std::runtime_error("no scenario '" + name + "' in suite " + std::string(suite.name));
}

bool isAsked(const Scenario& scenario, const RunOptions& options) {
  return options.only.empty() || std::ranges::find(options.only, scenario.name) != options.only.end();
}

}  // namespace

std::vector<Suite> suites() {
  return {calibration::suite(), robot::suite(), tracking::suite(), vision::suite()};
}

Report runSuite(const Suite& suite, const RunOptions& options) {
  refuseUnknown(suite, options);
  Report report{std::string(suite.name), options.quick, kSeed, thisMachine(), {}};
  Run run{options, report};
  for (const Scenario& scenario : suite.scenarios) {
    if (!isAsked(scenario, options)) continue;
    std::cerr << scenario.name << " ..." << std::flush;
    const TimePoint start = Clock::now();
    const std::size_t first = report.rows.size();
    scenario.run(run);
    for (std::size_t i = first; i < report.rows.size(); ++i) report.rows[i].section = scenario.title;
    std::cerr << " " << shortNumber(secondsBetween(start, Clock::now())) << " s\n";
  }
  return report;
}

}  // namespace mirrorarm::benchmarks
