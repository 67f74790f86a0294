#include "core/calibration/hand_eye.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "benchmarks/calibration/opencv_hand_eye.h"
#include "benchmarks/calibration/suite.h"
#include "benchmarks/statistics.h"
#include "tests/calibration/moveit_pairs.h"
#include "tests/calibration/stations.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;
using Eigen::Vector3d;

constexpr int kStations = 15;
constexpr double kGoalOutlier_mm = 0.6;
constexpr double kGoalMoveIt = 0.005;  // of the published place
const Vector3d kMoveItPlace(0.659, -0.249, 0.830);
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

StationMaker maker(std::uint64_t seed) {
  StationMaker made;
  made.noise_m = 3e-4;
  made.noise_deg = 0.03;
  made.random.seed(static_cast<std::mt19937::result_type>(seed));
  return made;
}

double error_mm(const RigidTransform& X_FC, const RigidTransform& truth) {
  return 1e3 * (X_FC.translation() - truth.translation()).norm();
}

/// Errors of the camera's place over many sets of stations.
struct Errors {
  RootMeanSquare ours;
  std::array<RootMeanSquare, kOpenCvMethods> opencv;
  int refused = 0;
  int sets_named_right = 0;  ///< the outliers named are those that were made
};

Errors errorsOver(int trials, double outlier_m) {
  Errors errors;
  for (int i = 0; i < trials; ++i) {
    auto make = maker(kSeed + static_cast<std::uint64_t>(i));
    auto pairs = make.stations(kStations);
    const auto which = static_cast<std::size_t>(i % kStations);
    pairs[which].X_CM.translation() += outlier_m * make.normal3().normalized();
    for (std::size_t k = 0; k < kOpenCvMethods; ++k)
      if (const auto X_FC = handEyeByOpenCv(k, pairs); X_FC && X_FC->matrix().allFinite())
        errors.opencv[k].addSquare(std::pow(error_mm(*X_FC, make.X_FC), 2));
    const auto solved = solveHandEye(pairs, CameraMount::kInHand);
    if (!solved) {
      ++errors.refused;
      continue;
    }
    errors.ours.addSquare(std::pow(error_mm(solved->X_PC, make.X_FC), 2));
    const auto expected = outlier_m > 0.0 ? std::vector{which} : std::vector<std::size_t>{};
    errors.sets_named_right += solved->outliers == expected ? 1 : 0;
  }
  return errors;
}

std::vector<Figure> openCvFigures(const Errors& errors) {
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < kOpenCvMethods; ++k)
    figures.push_back({kOpenCvMethodNames[k], errors.opencv[k].value(), "mm"});
  return figures;
}

void addSynthetic(Run& run, const std::string& name, const std::string& goal, double outlier_m) {
  const int trials = run.trials(200, 10);
  const auto errors = errorsOver(trials, outlier_m);
  const double named = static_cast<double>(errors.sets_named_right) / trials;
  const bool holds =
      errors.ours.value() <= kGoalOutlier_mm && (outlier_m == 0.0 || errors.sets_named_right == trials);
  run.report.rows.push_back({"",
                             name,
                             goal,
                             {{"rms", errors.ours.value(), "mm"},
                              {"sets with the right stations named", named, ""},
                              {"refused", static_cast<double>(errors.refused), ""}},
                             openCvFigures(errors),
                             goal.empty() ? std::nullopt : std::optional(holds)});
}

void addMoveIt(Run& run) {
  const std::filesystem::path file = SHARED_DATA "/moveit-handeye/pose_samples.json";
  if (!std::filesystem::exists(file)) return;
  const auto pairs = readMoveItPairs(file);
  auto inverted = pairs;  // a camera beside the robot, for methods that know only one in the hand
  for (auto& pair : inverted) pair.X_BF = pair.X_BF.inverse();
  const auto off = [](const Vector3d& t) { return (t - kMoveItPlace).norm() / kMoveItPlace.norm(); };
  const auto solved = solveHandEye(pairs, CameraMount::kToHand);
  std::vector<Figure> references;
  for (std::size_t k = 0; k < kOpenCvMethods; ++k) {
    const auto X_BC = handEyeByOpenCv(k, inverted);
    references.push_back({kOpenCvMethodNames[k], X_BC ? 100.0 * off(X_BC->translation()) : kNone, "%"});
  }
  const Vector3d t = solved ? Vector3d(solved->X_PC.translation()) : Vector3d::Constant(kNone);
  run.report.rows.push_back(
      {"",
       "MoveIt's samples, place off (0.659, -0.249, 0.830) m",
       "<= 0.5 %",
       {{"of its length", 100.0 * off(t), "%"},
        {"worst axis", 100.0 * ((t - kMoveItPlace).array() / kMoveItPlace.array()).abs().maxCoeff(), "%"}},
       references,
       off(t) <= kGoalMoveIt});
}

}  // namespace

void measureHandEye(Run& run) {
  addSynthetic(run, "15 stations, 0.3 mm and 0.03 deg of noise", "", 0.0);
  addSynthetic(run, "the same, one of them 50 mm off", "<= 0.6 mm, the station named", 0.05);
  addMoveIt(run);
}

}  // namespace mirrorarm::benchmarks::calibration
