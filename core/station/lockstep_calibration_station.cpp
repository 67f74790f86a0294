#include "core/station/lockstep_calibration_station.h"

#include <deque>

#include "core/station/calibration_stages.h"
#include "core/station/even_beat.h"
#include "core/station/stages.h"

namespace mirrorarm::station {
namespace {

/// What stands in for the time that the board is sought, which a repeatable run cannot measure.
constexpr Seconds kProcessing{0.020};

}  // namespace

struct LockstepCalibrationStation::Body {
  Body(const Equipment& given, const CalibrationSettings& settings, ManualTime& clock)
      : equipment(given), stages(equipment, settings, jobs), time(clock), now(clock.now()) {
    if (equipment.robot != nullptr) step = toClock(equipment.robot->period());
  }

  void advanceTo(TimePoint until) {
    while (now + step <= until) {
      now += step;
      time.set(now);
      cycle();
    }
  }

  void cycle() {
    if (stages.servo) stages.servo->step(now);
    if (const auto frame = equipment.cameras->next(Seconds(0.0))) {
      stages.control.frameCame(frame->exposed_at);
      under_way.push_back({now + toClock(kProcessing), stages.boards.process(*frame)});
    }
    while (!under_way.empty() && under_way.front().arrives <= now) {
      stages.control.report(under_way.front().report);
      under_way.pop_front();
    }
    if (control_beat.isDue(now)) stages.control.step(now);
  }

  struct Report {
    TimePoint arrives;
    BoardReport report;
  };
  const Equipment equipment;
  JobsAtOnce jobs;
  CalibrationStages stages;
  ManualTime& time;
  TimePoint now;
  Clock::duration step = toClock(kControlPeriod);
  std::deque<Report> under_way;
  DueBeat control_beat{kControlPeriod};
};

LockstepCalibrationStation::LockstepCalibrationStation(const Equipment& equipment,
                                                       const CalibrationSettings& settings, ManualTime& time)
    : body_(std::make_unique<Body>(equipment, settings, time)) {}

LockstepCalibrationStation::~LockstepCalibrationStation() { body_->stages.control.end(); }

void LockstepCalibrationStation::advanceTo(TimePoint time) { body_->advanceTo(time); }

CalibrationAnswer LockstepCalibrationStation::request(const CalibrationCommand& command) {
  return body_->stages.control.request(command);
}

void LockstepCalibrationStation::stop(control::StopReason reason) noexcept { body_->stages.stop(reason); }

void LockstepCalibrationStation::resetStop() noexcept { body_->stages.resetStop(); }

void LockstepCalibrationStation::setEnabling(control::EnablingPosition position) noexcept {
  body_->stages.setEnabling(position);
}

CalibrationSnapshot LockstepCalibrationStation::snapshot() { return body_->stages.snapshot(); }

}  // namespace mirrorarm::station
