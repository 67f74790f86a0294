#include <stdexcept>

#include "benchmarks/calibration/suite.h"
#include "core/common/resources.h"
#include "core/experiments/accuracy.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using Eigen::Vector3d;

constexpr double kGoal_mm = 0.05;
const Vector3d kPaper_mm(0.23, 0.23, 0.42);

std::vector<Figure> byAxis(const std::string& name, const Vector3d& v_mm) {
  return {{name + " x", v_mm.x(), "mm"}, {name + " y", v_mm.y(), "mm"}, {name + " z", v_mm.z(), "mm"}};
}

}  // namespace

void measureWholeChain(Run& run) {
  Vector3d std_mm = Vector3d::Zero(), bias_mm = Vector3d::Zero(), given_mm = Vector3d::Zero();
  double hand_eye_mm = 0.0;
  const int trials = run.trials(4, 1);
  for (int i = 0; i < trials; ++i) {
    const auto result = experiments::measureAccuracy(resourceFolder(), kSeed + static_cast<std::uint64_t>(i));
    if (!result) throw std::runtime_error(result.error());
    std_mm = std_mm.cwiseMax(result->chain.std_mm);
    bias_mm = bias_mm.cwiseMax(result->chain.bias_mm.cwiseAbs());
    given_mm = given_mm.cwiseMax(result->given.std_mm);
    hand_eye_mm = std::max(hand_eye_mm, result->calibration.handEyeError_mm());
  }
  auto references = byAxis("the paper", kPaper_mm);
  for (auto& figure : byAxis("true calibration", given_mm)) references.push_back(figure);
  const std::string of = ", worst of " + std::to_string(trials);
  run.report.rows.push_back({"", "std of the target's place in the base" + of, "<= 0.05 mm each",
                             byAxis("std", std_mm), references, std_mm.maxCoeff() <= kGoal_mm});
  auto biases = byAxis("bias", bias_mm);
  biases.push_back({"hand-eye, error of the position", hand_eye_mm, "mm"});
  run.report.rows.push_back({"", "mean error of the same" + of, "", biases, {}, {}});
}

}  // namespace mirrorarm::benchmarks::calibration
