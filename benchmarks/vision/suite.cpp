#include "benchmarks/vision/suite.h"

namespace mirrorarm::benchmarks::vision {

Suite suite() {
  return {"vision",
          "Marker vision, from pixels to 3D points",
          {{"random", "Random centre error (rms per axis) and honesty of its covariance", measureRandomError},
           {"ramp", "Linear ramp of the reflectance (rms per axis)", measureRamp},
           {"bias", "Systematic centre error through a fisheye (rms per axis, no noise)", measureBias},
           {"cut", "Discs that a straight occluder cuts", measureCutDiscs},
           {"recall", "Recall and false discs among spurious reflections", measureRecall}}};
}

}  // namespace mirrorarm::benchmarks::vision
