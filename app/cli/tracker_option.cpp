#include "app/cli/tracker_option.h"

#include <string>

#include <CLI/Validators.hpp>

namespace mirrorarm::cli {

CLI::Option* addTrackerOption(CLI::App& command, tracking::TrackingMethod& method) {
  const auto known = [](const std::string& name) {
    return tracking::trackingMethodOf(name) ? std::string() : "there is no tracker '" + name + "'";
  };
  return command
      .add_option_function<std::string>(
          "--tracker", [&method](const std::string& name) { method = *tracking::trackingMethodOf(name); },
          "How targets are found: cliques (default) or softassign, the paper's")
      ->check(known);
}

}  // namespace mirrorarm::cli
