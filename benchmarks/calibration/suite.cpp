#include "benchmarks/calibration/suite.h"

namespace mirrorarm::benchmarks::calibration {

Suite suite() {
  return {"calibration",
          "Calibration, from images and robot poses to rig, hand-eye and clock",
          {{"photographs", "A real chessboard before two real cameras", measurePhotographs},
           {"rig", "The simulated rig of 135 degrees, a dot plate in 30 views", measureSimulatedRig},
           {"chain", "Calibrated stereo, calibrated hand-eye and tracking over the paper's cuboid",
            measureWholeChain},
           {"hand-eye", "The camera on the flange, or beside the robot", measureHandEye},
           {"refusals", "Stations that do not determine the camera", measureRefusals},
           {"clock", "Two streams of poses on two clocks", measureClock}}};
}

}  // namespace mirrorarm::benchmarks::calibration
