#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "benchmarks/calibration/opencv_stereo.h"
#include "benchmarks/calibration/suite.h"
#include "core/common/resources.h"
#include "core/experiments/accuracy.h"
#include "core/experiments/rig_bias.h"
#include "core/experiments/trial_calibration.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;
using experiments::RigBias;

constexpr double kGoalReprojection_px = 0.03;
constexpr double kGoalBias_mm = 0.03;
constexpr double kPaperReprojection_px = 0.29;

/// Of the trials the worst.
struct Worst {
  double rms_px = 0.0, bias_mm = 0.0, shape_mm = 0.0, opencv_rms_px = 0.0, opencv_bias_mm = 0.0,
         opencv_shape_mm = 0.0;
};

void take(Worst& worst, const experiments::RigTrial& trial) {
  const auto cuboid_C = experiments::paperCuboid_C(trial.true_rig);
  const RigBias ours = experiments::biasOf(trial.stereo.rig, trial.true_rig, cuboid_C);
  worst.rms_px = std::max(worst.rms_px, trial.stereo.rms_px);
  worst.bias_mm = std::max(worst.bias_mm, ours.rms_mm);
  worst.shape_mm = std::max(worst.shape_mm, ours.shape_rms_mm);
  const auto& lens = trial.true_rig.left.intrinsics();
  const auto by_opencv = solveByOpenCv(trial.plate, trial.views, {lens.width_px, lens.height_px}, lens.model);
  if (!by_opencv) {
    worst.opencv_rms_px = worst.opencv_bias_mm = worst.opencv_shape_mm =
        std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const RigBias theirs = experiments::biasOf(by_opencv->rig, trial.true_rig, cuboid_C);
  worst.opencv_rms_px = std::max(worst.opencv_rms_px, by_opencv->rms_px);
  worst.opencv_bias_mm = std::max(worst.opencv_bias_mm, theirs.rms_mm);
  worst.opencv_shape_mm = std::max(worst.opencv_shape_mm, theirs.shape_rms_mm);
}

}  // namespace

void measureSimulatedRig(Run& run) {
  Worst worst;
  const int trials = run.trials(8, 1);
  for (int i = 0; i < trials; ++i) {
    const auto trial = experiments::calibrateRigInSimulation(resourceFolder(),
                                                             {.seed = kSeed + static_cast<std::uint64_t>(i)});
    if (!trial) throw std::runtime_error(trial.error());
    take(worst, *trial);
  }
  const std::string of = ", worst of " + std::to_string(trials);
  run.report.rows.push_back({"",
                             "reprojection" + of,
                             "<= 0.03 px",
                             {{"rms", worst.rms_px, "px"}},
                             {{"OpenCV on the same centres", worst.opencv_rms_px, "px"},
                              {"the paper, real cameras", kPaperReprojection_px, "px"}},
                             worst.rms_px <= kGoalReprojection_px});
  run.report.rows.push_back({"",
                             "3D bias over the paper's cuboid, no noise" + of,
                             "<= 0.03 mm",
                             {{"rms", worst.bias_mm, "mm"}, {"of the shape alone", worst.shape_mm, "mm"}},
                             {{"OpenCV on the same centres", worst.opencv_bias_mm, "mm"},
                              {"OpenCV, of the shape alone", worst.opencv_shape_mm, "mm"}},
                             worst.bias_mm <= kGoalBias_mm});
}

}  // namespace mirrorarm::benchmarks::calibration
