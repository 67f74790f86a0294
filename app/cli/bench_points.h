#pragma once

#include <cstdint>

#include "app/cli/point_source.h"
#include "core/tracking/target.h"

namespace mirrorarm::cli {

/// What the simulated bench's cameras see of a patient who moves, for ever and in real time. Throws
/// InputRefused.
[[nodiscard]] std::unique_ptr<PointSource> openBenchPoints(std::uint64_t seed, vision::CentreMethod method);

/// The target that is before the cameras, learnt until it is known precisely or for some seconds; throws
/// CommandFailed where there is none.
[[nodiscard]] tracking::Target taughtFrom(PointSource& source, const std::string& name);

}  // namespace mirrorarm::cli
