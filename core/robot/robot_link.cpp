#include "core/robot/robot_link.h"

namespace mirrorarm::robot {

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

}  // namespace mirrorarm::robot
