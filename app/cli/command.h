#pragma once

#include <stdexcept>
#include <string>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "core/common/file_error.h"

namespace mirrorarm::cli {

/// What a command leaves for main(): the object that --json prints as the last line of standard output.
struct Context {
  bool json = false;
  nlohmann::ordered_json result;
};

/// Wrong use or wrong input: one line on standard error, exit 2.
class InputRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work itself failed: one line on standard error, exit 1.
class CommandFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The value, or InputRefused with the file, the line and the reason.
template <class T>
T orRefuse(FromFile<T> value) {
  if (!value) throw InputRefused(describe(value.error()));
  return std::move(*value);
}

/// Throws CommandFailed where a result could not be written.
void orFail(const Expected<void, std::string>& written);

/// Refuses a path that is not there.
void requireExists(const std::filesystem::path& path);

/// Adds a subcommand with --json and an example at the end of its --help.
CLI::App* addCommand(CLI::App& parent, Context& context, const std::string& name,
                     const std::string& description, const std::string& example);

}  // namespace mirrorarm::cli
