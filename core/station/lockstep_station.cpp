#include "core/station/lockstep_station.h"

#include <deque>

#include "core/station/even_beat.h"
#include "core/station/stages.h"

namespace mirrorarm::station {
namespace {

/// What stands in for the computing time of a frame, which a repeatable run cannot measure: more than it
/// takes (docs/benchmarks.md) once the target is tracked.
constexpr Seconds kProcessing{0.005};

}  // namespace

struct LockstepStation::Body {
  Body(const Equipment& given, const StationSettings& settings, ManualTime& clock)
      : equipment(given), stages(equipment, settings), time(clock), now(clock.now()) {}

  void advanceTo(TimePoint until) {
    while (now + toClock(equipment.robot->period()) <= until) {
      now += toClock(equipment.robot->period());
      time.set(now);
      cycle();
    }
  }

  void cycle() {
    stages.servo.step(now);
    if (const auto frame = equipment.cameras->next(Seconds(0.0))) {
      under_way.push_back({now + toClock(kProcessing), stages.tracking.process(*frame)});
      stages.tracking.settle();
    }
    const bool reported = !under_way.empty() && under_way.front().arrives <= now;
    if (reported) {
      stages.control.report(under_way.front().report);
      under_way.pop_front();
    }
    if (control_beat.isDue(now) || reported) stages.control.step(now);
    stages.desk.answer();
    if (recorder_beat.isDue(now)) stages.recorder.step();
  }

  struct Report {
    TimePoint arrives;
    FrameReport report;
  };
  const Equipment equipment;
  Stages stages;
  ManualTime& time;
  TimePoint now;
  std::deque<Report> under_way;
  DueBeat control_beat{kControlPeriod};
  DueBeat recorder_beat{kRecorderPeriod};
};

LockstepStation::LockstepStation(const Equipment& equipment, const StationSettings& settings,
                                 ManualTime& time)
    : body_(std::make_unique<Body>(equipment, settings, time)) {}

LockstepStation::~LockstepStation() {
  body_->stages.control.end();
  body_->stages.recorder.step();
}

void LockstepStation::advanceTo(TimePoint time) { body_->advanceTo(time); }

Answer LockstepStation::request(const Command& command) { return body_->stages.control.request(command); }

Answer LockstepStation::changeHelp(const control::Help& help) {
  return body_->stages.control.changeHelp(help);
}

void LockstepStation::stop(control::StopReason reason) noexcept { body_->stages.servo.stop(reason); }

void LockstepStation::resetStop() noexcept { body_->stages.servo.resetStop(); }

void LockstepStation::setEnabling(control::EnablingPosition position) noexcept {
  body_->stages.servo.setEnabling(position);
}

Snapshot LockstepStation::snapshot() { return body_->stages.snapshot(); }

}  // namespace mirrorarm::station
