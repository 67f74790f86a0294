#include "core/station/servo_thread.h"

#include "core/common/log.h"
#include "core/devices/real_time.h"
#include "core/station/even_beat.h"

namespace mirrorarm::station {
namespace {

/// A robot that sets the pace may be silent so long before the watchdogs are asked.
constexpr double kSilentCycles = 3.0;

void tellRealTime(const devices::RealTimeGrant& grant) {
  log(grant.isFull() ? LogLevel::kInfo : LogLevel::kWarning,
      "servo: " + schedulingLine(grant) + "; " + memoryLine(grant));
}

}  // namespace

void runServo(const std::stop_token& stop, control::ServoLoop& servo, robot::RobotLink& robot) {
  tellRealTime(devices::askForRealTime());
  if (!robot.setsThePace()) atEvenBeat(stop, robot.period(), [&](TimePoint now) { servo.step(now); });
  while (!stop.stop_requested()) {
    robot.awaitCycle(kSilentCycles * robot.period());
    servo.step(Clock::now());
  }
  haltToRest(robot);
}

}  // namespace mirrorarm::station
