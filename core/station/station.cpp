#include "core/station/station.h"

#include <thread>

#include "core/common/log.h"
#include "core/common/signal.h"
#include "core/station/even_beat.h"
#include "core/station/servo_thread.h"
#include "core/station/stages.h"

namespace mirrorarm::station {
namespace {

/// Long enough to idle quietly, short enough that the program ends at once.
constexpr Seconds kPatience{0.1};

}  // namespace

struct Station::Body {
  Body(const Equipment& given, const StationSettings& settings)
      : equipment(given),
        stages(equipment, settings),
        recorder([this](const std::stop_token& stop) { record(stop); }),
        servo([this](const std::stop_token& stop) { runServo(stop, stages.servo, *equipment.robot); }),
        planning([this](const std::stop_token& stop) { plan(stop); }),
        control([this](const std::stop_token& stop) { decide(stop); }),
        tracking([this](const std::stop_token& stop) { track(stop); }),
        acquisition([this](const std::stop_token& stop) { guarded([&] { acquire(stop); }); }) {}

  void acquire(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const auto frame = equipment.cameras->next(kPatience);
      if (frame) {
        static_cast<void>(
            frames.put(*frame));  // the gap in the sequence tells of a frame that was overwritten
        frame_came.notify();
      } else if (frame.error() != camera::NoFrame::kTimeout) {
        return;  // the supervisor notices that no frame comes any more
      }
    }
  }

  void track(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      frame_came.waitFor(kPatience);
      if (const auto* frame = frames.take())
        guarded([&] {
          stages.control.report(stages.tracking.process(*frame));
          report_came.notify();
          stages.tracking.settle();
        });
    }
  }

  void decide(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      report_came.waitFor(kControlPeriod);
      guarded([&] { stages.control.step(Clock::now()); });
    }
    guarded([&] { stages.control.end(); });
  }

  void plan(const std::stop_token& stop) {
    while (!stop.stop_requested()) guarded([this] { stages.desk.awaitAndAnswer(kPatience); });
  }

  void record(const std::stop_token& stop) {
    atEvenBeat(stop, kRecorderPeriod, [this](TimePoint) { guarded([&] { stages.recorder.step(); }); });
    guarded([&] { stages.recorder.step(); });
  }

  /// Any way out of a stage stops the robot.
  template <class Work>
  void guarded(Work work) {
    try {
      work();
    } catch (const std::exception& failure) {
      stages.servo.stop(control::StopReason::kInternal);
      log(LogLevel::kError, std::string("station: ") + failure.what());
    }
  }

  const Equipment equipment;
  Stages stages;
  LatestValue<camera::StereoFrame> frames;
  Signal frame_came;
  Signal report_came;
  // Last members, joined from the last to the first: the cameras end before the robot, the record at the very
  // end.
  std::jthread recorder;
  std::jthread servo;
  std::jthread planning;
  std::jthread control;
  std::jthread tracking;
  std::jthread acquisition;
};

Station::Station(const Equipment& equipment, const StationSettings& settings)
    : body_(std::make_unique<Body>(equipment, settings)) {}

Station::~Station() = default;

Answer Station::request(const Command& command) { return body_->stages.control.request(command); }

Answer Station::changeHelp(const control::Help& help) { return body_->stages.control.changeHelp(help); }

void Station::stop(control::StopReason reason) noexcept { body_->stages.servo.stop(reason); }

void Station::resetStop() noexcept { body_->stages.servo.resetStop(); }

void Station::setEnabling(control::EnablingPosition position) noexcept {
  body_->stages.servo.setEnabling(position);
}

Snapshot Station::snapshot() { return body_->stages.snapshot(); }

}  // namespace mirrorarm::station
