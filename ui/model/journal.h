#pragma once

#include <array>
#include <optional>

#include "core/station/snapshot.h"
#include "ui/model/log_model.h"

namespace mirrorarm::ui {

/// Compares each snapshot with the one before and writes what changed into the log. Stops are alarms and
/// written as such.
class Journal {
 public:
  /// `log` outlives the journal.
  explicit Journal(LogModel& log) : log_(log) {}
  void show(const station::Snapshot& snapshot);

 private:
  struct Seen {
    therapy::Phase phase;
    control::StopReason stop;
    control::Help help;
    station::Recording recording;
    std::uint32_t answers;
    std::array<int, tracking::kSkinEventCount> skin_events;
  };
  void compare(const Seen& before, const Seen& now, station::Answer answer);

  LogModel& log_;
  std::optional<Seen> before_;
};

}  // namespace mirrorarm::ui
