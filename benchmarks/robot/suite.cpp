#include "benchmarks/robot/suite.h"

namespace mirrorarm::benchmarks::robot {

Suite suite() {
  return {"robot",
          "The robot that follows: kinematics, planning, motion, guard, links",
          {{"fri", "An LBR 4+ over its Fast Research Interface", measureFri},
           {"motion", "Jerk-limited motion planned anew", measureMotion}}};
}

}  // namespace mirrorarm::benchmarks::robot
