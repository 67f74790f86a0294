#include "benchmarks/vision/suite.h"

namespace mirrorarm::benchmarks::vision {

Suite suite() {
  return {"vision",
          "Marker vision, from pixels to 3D points",
          {{"random", "Random centre error (rms per axis) and honesty of its covariance", measureRandomError},
           {"ramp", "Linear ramp of the reflectance (rms per axis)", measureRamp},
           {"bias", "Systematic centre error through a fisheye (rms per axis, no noise)", measureBias},
           {"cut", "Discs that a straight occluder cuts", measureCutDiscs},
           {"recall", "Recall and false discs among spurious reflections", measureRecall},
           {"covariance", "Honesty of the covariance of points and corrected centres, 300-600 mm",
            measurePointCovariance},
           {"time", "Time from both images, 1296 x 964, to matched 3D points", measureFrameTime},
           {"disc-time", "Time of each method", measureDiscTime}}};
}

}  // namespace mirrorarm::benchmarks::vision
