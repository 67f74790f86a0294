#include "benchmarks/robot/suite.h"

namespace mirrorarm::benchmarks::robot {

Suite suite() {
  return {"robot",
          "The robot that follows: kinematics, planning, motion, guard, links",
          {{"fri", "An LBR 4+ over its Fast Research Interface", measureFri},
           {"guard", "The motion guard against every kind of wish", measureGuard},
           {"inverse-kinematics", "Joints for a pose of the flange", measureInverseKinematics},
           {"latency", "The whole program follows a target that a second robot moves", measureLatency},
           {"motion", "Jerk-limited motion planned anew", measureMotion},
           {"planning", "Ways around what stands between", measurePlanning},
           {"stop", "Stops through the servo loop and the drives", measureStop}}};
}

}  // namespace mirrorarm::benchmarks::robot
