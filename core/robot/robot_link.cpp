#include "core/robot/robot_link.h"

namespace mirrorarm::robot {
namespace {

constexpr double kRest_rad_s = 1e-2;
constexpr Seconds kCalm{0.1};  // at rest; a program on the controller takes some cycles to heed the halt
constexpr double kSilentCycles = 3.0;

bool isAtRest(const Expected<RobotState, LinkFault>& read) {
  return read && read->v_rad_s.size() > 0 && read->v_rad_s.cwiseAbs().maxCoeff() < kRest_rad_s;
}

}  // namespace

std::string_view id(LinkFault fault) {
  switch (fault) {
    case LinkFault::kNone:
      return "none";
    case LinkFault::kNoAnswer:
      return "no_answer";
    case LinkFault::kNotReady:
      return "not_ready";
    case LinkFault::kDriveFault:
      return "drive_fault";
    case LinkFault::kPoorLine:
      return "poor_line";
  }
  return "unknown";
}

void haltToRest(RobotLink& link, Seconds longest) noexcept {
  link.halt();
  if (!link.setsThePace()) return;
  TimePoint now = Clock::now(), moved_at = now;
  const TimePoint end = now + toClock(longest);
  while (now < end && now - moved_at < kCalm) {
    link.awaitCycle(kSilentCycles * link.period());
    now = Clock::now();
    if (!isAtRest(link.read())) moved_at = now;
    link.halt();
  }
}

}  // namespace mirrorarm::robot
