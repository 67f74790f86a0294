#pragma once

#include <CLI/App.hpp>

#include "core/vision/finder_settings.h"

namespace mirrorarm::cli {

/// Adds --method, which fills `method` and refuses names that are none.
CLI::Option* addMethodOption(CLI::App& command, vision::CentreMethod& method);

/// The usual search for markers, with this method.
[[nodiscard]] vision::FinderSettings finderOf(vision::CentreMethod method);

}  // namespace mirrorarm::cli
