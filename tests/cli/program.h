#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "tests/common/scratch_folder.h"

namespace mirrorarm::cli {

/// What a run of mirrorarm-cli left.
struct Run {
  int exit_code = -1;
  std::string out;
  std::string err;

  /// The last line of standard output as JSON; discarded when it is none.
  [[nodiscard]] nlohmann::json json() const {
    const auto end = out.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const auto start = out.find_last_of('\n', end);
    return nlohmann::json::parse(out.substr(start == std::string::npos ? 0 : start + 1), nullptr, false);
  }
  [[nodiscard]] long lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// Runs mirrorarm-cli with `arguments` (as a shell reads them) and waits for it.
inline Run run(const std::string& arguments) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "out", err = scratch / "err";
  const std::string line =
      std::string(MIRRORARM_CLI) + " " + arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::bytesOf(out), test::bytesOf(err)};
}

inline std::filesystem::path shared(const std::string& path) {
  return std::filesystem::path(SHARED_DATA) / path;
}

}  // namespace mirrorarm::cli
