#pragma once

#include <mutex>
#include <vector>

#include "core/common/time.h"

namespace mirrorarm::simulation {

/// How far a movement has come: runs while switched on, rests while off, and takes half a second to change
/// its speed. A function of time, also of the past: the list of switches is kept. Any thread.
class MovementPhase {
 public:
  /// Switches at `time`, which is not earlier than any switch before; a repeated one changes nothing.
  void set(TimePoint time, bool moving);
  /// The movement's own time [s], >= 0.
  [[nodiscard]] double at(TimePoint time) const;

 private:
  struct Switch {
    TimePoint time{};
    double phase_s = 0.0;
    double speed = 0.0;   ///< when switched; 1 runs in real time
    double target = 0.0;  ///< speed half a second later
  };
  [[nodiscard]] static double phaseAfter(const Switch& from, double elapsed_s);
  [[nodiscard]] static double speedAfter(const Switch& from, double elapsed_s);

  mutable std::mutex mutex_;
  std::vector<Switch> switches_;  ///< guarded by mutex_
};

}  // namespace mirrorarm::simulation
