#include <array>
#include <cstdio>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "tests/ui/report/synthetic_record.h"

namespace mirrorarm::ui {
namespace {

struct Outcome {
  int code = -1;
  std::string said;
};

/// Runs the workstation as on a machine without a display.
Outcome run(const std::string& arguments) {
  const std::string command =
      "env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR " WORKSTATION " " + arguments;
  Outcome outcome;
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 256> text{};
  while (std::fgets(text.data(), text.size(), pipe)) outcome.said += text.data();
  outcome.code = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

class ReportCommand : public ::testing::Test {
 protected:
  [[nodiscard]] std::string order(const std::string& store, int session, const std::string& out) const {
    return "--report " + (record_.folder / store).string() + " --session " + std::to_string(session) +
           " --out " + (record_.folder / out).string();
  }
  void expectRefused(const std::string& arguments, int code, const std::string& reason) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.said;
    EXPECT_NE(outcome.said.find(reason), std::string::npos) << outcome.said;
    EXPECT_EQ(outcome.said.find('\n'), outcome.said.size() - 1) << outcome.said;
    EXPECT_FALSE(std::filesystem::exists(record_.folder / "x.pdf"));
  }
  SyntheticRecord record_{true, 480};
};

TEST_F(ReportCommand, NeedsNoDisplay) {
  for (const std::string language : {"en", "de"}) {
    const auto outcome = run(order("store.sqlite", 1, language + ".pdf") + " --language " + language);
    EXPECT_EQ(outcome.code, 0) << outcome.said;
    EXPECT_GT(std::filesystem::file_size(record_.folder / (language + ".pdf")), 10000u);
  }
}

TEST_F(ReportCommand, RefusesInOneLineAndLeavesNothing) {
  expectRefused(order("none.sqlite", 1, "x.pdf"), 2, "none.sqlite: is missing or empty");
  expectRefused(order("store.sqlite", 9, "x.pdf"), 2, "session 9: is not in the store");
  expectRefused(order("store.sqlite", 1, "x.pdf") + " --language xx", 2, "no translation to xx");
  expectRefused("--report " + (record_.folder / "store.sqlite").string(), 2, "--session");
  expectRefused(order("store.sqlite", 1, "x.pdf") + " --nonsense", 2, "nonsense");
}

TEST_F(ReportCommand, FailsWhereThePdfCannotBeWritten) {
  expectRefused(order("store.sqlite", 1, "store.sqlite/x.pdf"), 1, "store.sqlite/x.pdf");
}

}  // namespace
}  // namespace mirrorarm::ui
