#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

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

/// A folder of its own, gone with the test.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "mirrorarm-cli-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  /// Writes a file with this text.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

inline std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Runs mirrorarm-cli with `arguments` (as a shell reads them) and waits for it.
inline Run run(const std::string& arguments) {
  const Scratch scratch;
  const auto out = scratch / "out", err = scratch / "err";
  const std::string line =
      std::string(MIRRORARM_CLI) + " " + arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, textOf(out), textOf(err)};
}

inline std::filesystem::path shared(const std::string& path) {
  return std::filesystem::path(SHARED_DATA) / path;
}

}  // namespace mirrorarm::cli
