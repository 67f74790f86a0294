#include "app/cli/command.h"

#include <CLI/Formatter.hpp>

namespace mirrorarm::cli {

void orFail(const Expected<void, std::string>& written) {
  if (!written) throw CommandFailed(written.error());
}

void requireExists(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw InputRefused(path.string() + ": is missing");
}

CLI::App* addCommand(CLI::App& parent, Context& context, const std::string& name,
                     const std::string& description, const std::string& example) {
  CLI::App* command = parent.add_subcommand(name, description);
  command->add_flag("--json", context.json, "Print one JSON object as the last line of standard output");
  command->footer("Example:\n  " + example);
  return command;
}

}  // namespace mirrorarm::cli
