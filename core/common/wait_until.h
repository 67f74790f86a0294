#pragma once

#include "core/common/time_source.h"

namespace mirrorarm {

/// Waits until `time` has reached `due`, at most `timeout` of real time; false when it has not by then. With
/// timeout 0 it only looks. For devices' threads: it sleeps.
[[nodiscard]] bool waitUntil(const TimeSource& time, TimePoint due, Seconds timeout);

}  // namespace mirrorarm
