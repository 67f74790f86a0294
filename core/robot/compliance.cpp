#include "core/robot/compliance.h"

namespace mirrorarm::robot {

std::string_view id(GivesWay gives_way) {
  switch (gives_way) {
    case GivesWay::kNot:
      return "not";
    case GivesWay::kInJoints:
      return "in_joints";
    case GivesWay::kAtTool:
      return "at_tool";
  }
  return "unknown";
}

}  // namespace mirrorarm::robot
