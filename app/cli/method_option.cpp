#include "app/cli/method_option.h"

#include <string>

#include <CLI/Validators.hpp>

namespace mirrorarm::cli {

CLI::Option* addMethodOption(CLI::App& command, vision::CentreMethod& method) {
  const auto known = [](const std::string& name) {
    return vision::centreMethodOf(name) ? std::string() : "there is no method '" + name + "'";
  };
  return command
      .add_option_function<std::string>(
          "--method", [&method](const std::string& name) { method = *vision::centreMethodOf(name); },
          "How centres are measured: maximum_likelihood (default), dual_conic or lindeberg_fitzgibbon")
      ->check(known);
}

vision::FinderSettings finderOf(vision::CentreMethod method) {
  vision::FinderSettings settings;
  settings.method = method;
  return settings;
}

}  // namespace mirrorarm::cli
