#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace mirrorarm::workstation {

/// What `mirrorarm --report` is asked for.
struct ReportOrder {
  std::filesystem::path store;
  std::int64_t session = 0;
  std::filesystem::path out;
  std::string language = "en";
};

/// Makes the report of one session without a display. Gives the program's exit code: 0 done, 2 wrong store,
/// session or language, 1 where the PDF could not be made; one line on standard error says why.
[[nodiscard]] int runReport(const ReportOrder& order, int argc, char** argv);

}  // namespace mirrorarm::workstation
