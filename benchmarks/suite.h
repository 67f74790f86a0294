#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/report.h"

namespace mirrorarm::benchmarks {

/// How a run was asked for.
struct RunOptions {
  std::filesystem::path out;      ///< reports and pictures go here
  bool quick = false;             ///< few trials: shows that it runs, not how well
  std::vector<std::string> only;  ///< names of scenarios; empty for all
};

inline constexpr std::uint64_t kSeed = 20151213;

/// What a scenario works with while it runs.
struct Run {
  const RunOptions& options;
  Report& report;

  /// `full` trials, or `quick` ones when a quick run was asked for.
  [[nodiscard]] int trials(int full, int quick) const { return options.quick ? quick : full; }
};

/// A group of rows on the same data. Throws std::runtime_error when it cannot run.
struct Scenario {
  std::string_view name;
  std::string_view title;  ///< section of the table
  void (*run)(Run& run);
};

/// What `mirrorarm-benchmark <name>` runs.
struct Suite {
  std::string_view name;
  std::string_view what;
  std::vector<Scenario> scenarios;
};

/// Every suite there is.
[[nodiscard]] std::vector<Suite> suites();

/// Runs the scenarios asked for, one after the other; says on standard error which. Throws
/// std::runtime_error, also for a name in `only` that is none.
[[nodiscard]] Report runSuite(const Suite& suite, const RunOptions& options);

}  // namespace mirrorarm::benchmarks
