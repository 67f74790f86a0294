#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/common/expected.h"

namespace mirrorarm::benchmarks {

/// One number of a row; not a number where it could not be measured.
struct Figure {
  std::string name;  ///< of the method or the statistic
  double value = 0.0;
  std::string unit;  ///< "px", "ms", "" for shares and ratios
};

/// One line of the table.
struct Row {
  std::string section;  ///< scenario it belongs to
  std::string name;
  std::string goal;                ///< in words; empty where none is set
  std::vector<Figure> measured;    ///< what the goal speaks of first
  std::vector<Figure> references;  ///< the same of other methods on the same data, and bounds
  std::optional<bool> pass;        ///< nothing where no goal is set
};

/// The machine that measured.
struct Machine {
  std::string processor;
  unsigned cores = 0;
};
[[nodiscard]] Machine thisMachine();

/// Everything that a run of one suite found.
struct Report {
  std::string suite;
  bool quick = false;
  std::uint64_t seed = 0;
  Machine machine;
  std::vector<Row> rows;
};

/// `value` with three significant digits, "-" when it is not a number.
[[nodiscard]] std::string shortNumber(double value);
/// The report for people: one table a section.
[[nodiscard]] std::string toMarkdown(const Report& report);
/// The report for programs; numbers that are none become null.
[[nodiscard]] std::string toJson(const Report& report);

/// Writes `<suite>.md` and `<suite>.json` into `folder`, each whole or not at all.
[[nodiscard]] Expected<void, std::string> writeReport(const std::filesystem::path& folder,
                                                      const Report& report);

}  // namespace mirrorarm::benchmarks
