#include "benchmarks/robot/suite.h"

namespace mirrorarm::benchmarks::robot {

Suite suite() {
  return {"robot",
          "The robot that follows: kinematics, planning, motion, guard, links",
          {{"motion", "Jerk-limited motion planned anew", measureMotion}}};
}

}  // namespace mirrorarm::benchmarks::robot
