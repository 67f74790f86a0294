#include "core/common/wait_until.h"

#include <algorithm>
#include <thread>

namespace mirrorarm {

bool waitUntil(const TimeSource& time, TimePoint due, Seconds timeout) {
  // Short steps: a clock that is set by someone else may jump to `due` at any moment.
  constexpr Clock::duration kStep = std::chrono::milliseconds(2);
  const TimePoint give_up = Clock::now() + toClock(timeout);
  for (;;) {
    const auto missing = due - time.now();
    if (missing <= Clock::duration::zero()) return true;
    const auto left = give_up - Clock::now();
    if (left <= Clock::duration::zero()) return false;
    std::this_thread::sleep_for(std::min({missing, left, kStep}));
  }
}

}  // namespace mirrorarm
