#include "core/station/calibration_station.h"

#include <thread>

#include "core/common/log.h"
#include "core/common/signal.h"
#include "core/station/calibration_stages.h"
#include "core/station/even_beat.h"
#include "core/station/servo_thread.h"
#include "core/station/stages.h"

namespace mirrorarm::station {
namespace {

/// Long enough to idle quietly, short enough that the program ends at once.
constexpr Seconds kPatience{0.1};

}  // namespace

struct CalibrationStation::Body {
  Body(const Equipment& given, const CalibrationSettings& settings)
      : equipment(given),
        stages(equipment, settings, jobs),
        control([this](const std::stop_token& stop) { decide(stop); }),
        vision([this](const std::stop_token& stop) { look(stop); }),
        acquisition([this](const std::stop_token& stop) { guarded([&] { acquire(stop); }); }) {
    if (!stages.servo) return;
    servo = std::jthread(
        [this](const std::stop_token& stop) { runServo(stop, *stages.servo, *equipment.robot); });
  }

  void acquire(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const auto frame = equipment.cameras->next(kPatience);
      if (frame) {
        stages.control.frameCame(frame->exposed_at);
        static_cast<void>(frames.put(*frame));  // the newest wins
        frame_came.notify();
      } else if (frame.error() != camera::NoFrame::kTimeout) {
        return;  // the control stage notices that no frame comes any more
      }
    }
  }

  void look(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      frame_came.waitFor(kPatience);
      if (const auto* frame = frames.take())
        guarded([&] { stages.control.report(stages.boards.process(*frame)); });
    }
  }

  void decide(const std::stop_token& stop) {
    atEvenBeat(stop, kControlPeriod, [this](TimePoint now) { guarded([&] { stages.control.step(now); }); });
    guarded([&] { stages.control.end(); });
  }

  /// Any way out of a stage stops the robot.
  template <class Work>
  void guarded(Work work) {
    try {
      work();
    } catch (const std::exception& failure) {
      stages.stop(control::StopReason::kInternal);
      log(LogLevel::kError, std::string("calibration: ") + failure.what());
    }
  }

  const Equipment equipment;
  JobsBeside jobs;
  CalibrationStages stages;
  LatestValue<camera::StereoFrame> frames;
  Signal frame_came;
  // Last members, joined from the last to the first: the robot rests before those end who could drive it.
  std::jthread control;
  std::jthread vision;
  std::jthread acquisition;
  std::jthread servo;
};

CalibrationStation::CalibrationStation(const Equipment& equipment, const CalibrationSettings& settings)
    : body_(std::make_unique<Body>(equipment, settings)) {}

CalibrationStation::~CalibrationStation() = default;

CalibrationAnswer CalibrationStation::request(const CalibrationCommand& command) {
  return body_->stages.control.request(command);
}

void CalibrationStation::stop(control::StopReason reason) noexcept { body_->stages.stop(reason); }

void CalibrationStation::resetStop() noexcept { body_->stages.resetStop(); }

void CalibrationStation::setEnabling(control::EnablingPosition position) noexcept {
  body_->stages.setEnabling(position);
}

CalibrationSnapshot CalibrationStation::snapshot() { return body_->stages.snapshot(); }

}  // namespace mirrorarm::station
