#include "benchmarks/tracking/suite.h"

namespace mirrorarm::benchmarks::tracking {

Suite suite() {
  return {"tracking",
          "Tracking, from points to poses",
          {{"registration", "One target from nothing, any rotation", measureRegistration},
           {"bodies", "Several targets from nothing", measureBodies},
           {"false-pose", "Poses found where the target is not", measureFalsePoses},
           {"pose", "Pose of a target of ten markers at 400 mm, given the rig", measurePose},
           {"prediction", "Prediction of a limb's place from its last poses", measurePrediction},
           {"skin", "Markers that skin moves against each other", measureSkin},
           {"chain", "Time from both images, 1296 x 964, to pose and covariance", measureChain},
           {"teaching", "Taught models against the truth", measureTeaching}}};
}

}  // namespace mirrorarm::benchmarks::tracking
