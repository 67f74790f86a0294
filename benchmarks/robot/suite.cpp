#include "benchmarks/robot/suite.h"

namespace mirrorarm::benchmarks::robot {

Suite suite() {
  return {"robot",
          "The robot that follows: kinematics, planning, motion, guard, links",
          {{"fri", "An LBR 4+ over its Fast Research Interface", measureFri},
           {"guard", "The motion guard against every kind of wish", measureGuard},
           {"motion", "Jerk-limited motion planned anew", measureMotion},
           {"stop", "Stops through the servo loop and the drives", measureStop}}};
}

}  // namespace mirrorarm::benchmarks::robot
