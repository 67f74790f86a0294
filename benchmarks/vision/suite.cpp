#include "benchmarks/vision/suite.h"

namespace mirrorarm::benchmarks::vision {

Suite suite() {
  return {"vision",
          "Marker vision, from pixels to 3D points",
          {{"random", "Random centre error (rms per axis) and honesty of its covariance", measureRandomError},
           {"ramp", "Linear ramp of the reflectance (rms per axis)", measureRamp}}};
}

}  // namespace mirrorarm::benchmarks::vision
