#include <memory>
#include <sstream>

#include "app/cli/experiment_commands.h"
#include "core/calibration/hand_eye_file.h"
#include "core/common/resources.h"
#include "core/experiments/accuracy.h"
#include "core/experiments/paper_figures.h"
#include "core/experiments/stream_accuracy.h"

namespace mirrorarm::cli {
namespace {

using experiments::AccuracyResult;
using experiments::AccuracyStatistics;
using experiments::StreamAccuracy;

nlohmann::ordered_json jsonOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json jsonOf(const AccuracyResult& result) {
  const auto& stereo = result.calibration.rig.stereo;
  return {{"std_mm", jsonOf(result.chain.std_mm)},
          {"bias_mm", jsonOf(result.chain.bias_mm)},
          {"rms_mm", result.chain.rms_mm},
          {"fit_rms_mm", result.fit_rms_mm},
          {"frames", result.frames},
          {"tracked", result.tracked},
          {"given_calibration",
           {{"std_mm", jsonOf(result.given.std_mm)},
            {"bias_mm", jsonOf(result.given.bias_mm)},
            {"rms_mm", result.given.rms_mm}}},
          {"calibration",
           {{"reprojection_px", stereo.rms_px},
            {"views", stereo.views},
            {"rig_bias_mm", result.rig_bias.rms_mm},
            {"rig_bias_largest_mm", result.rig_bias.largest_mm},
            {"rig_shape_bias_mm", result.rig_bias.shape_rms_mm},
            {"hand_eye_error_mm", result.calibration.handEyeError_mm()},
            {"hand_eye_residual_mm", 1e3 * result.calibration.hand_eye.rms_m}}},
          {"paper",
           {{"std_mm", experiments::paper::kStd_mm},
            {"fit_rms_mm", experiments::paper::kFitRms_mm},
            {"reprojection_px", experiments::paper::kReprojection_px}}}};
}

std::string triple(const Eigen::Vector3d& v_mm) {
  return fixedNumber(v_mm.x(), 3) + " / " + fixedNumber(v_mm.y(), 3) + " / " + fixedNumber(v_mm.z(), 3);
}

std::string line(const std::string& name, const AccuracyStatistics& of) {
  return "| " + name + " | " + triple(of.std_mm) + " | " + triple(of.bias_mm) + " | " +
         fixedNumber(of.rms_mm, 3) + " |\n";
}

std::string tableOf(const AccuracyResult& result) {
  using experiments::paper::kStd_mm;
  const auto& calibration = result.calibration;
  std::ostringstream out;
  out << "# Accuracy of the whole chain\n\n"
         "Cameras and hand-eye calibrated from simulated images, then the paper's cuboid of 60 x 60 x 40 mm "
         "in "
         "steps of 20 mm above a target of ten markers on a table; the robot's own poses are the truth. "
         "Errors "
         "of the target's middle along the axes of the robot's base.\n\n"
         "| | std x / y / z [mm] | bias x / y / z [mm] | rms [mm] |\n|---|---|---|---|\n"
      << line("everything calibrated", result.chain)
      << line("true rig and hand-eye: tracking alone", result.given) << "| the paper | " << kStd_mm[0]
      << " / " << kStd_mm[1] << " / " << kStd_mm[2] << " | - | - |\n\n"
      << "| | ours | the paper |\n|---|---|---|\n| reprojection [px] | "
      << fixedNumber(calibration.rig.stereo.rms_px, 4) << " | " << experiments::paper::kReprojection_px
      << " |\n| misfit of the target [mm] | " << fixedNumber(result.fit_rms_mm, 3) << " | "
      << experiments::paper::kFitRms_mm << " |\n| bias of a point by the rig alone, rms / largest [mm] | "
      << fixedNumber(result.rig_bias.rms_mm, 4) << " / " << fixedNumber(result.rig_bias.largest_mm, 4)
      << " | - |\n| hand-eye, error of the position [mm] | " << fixedNumber(calibration.handEyeError_mm(), 3)
      << " | - |\n| frames tracked | " << result.tracked << " of " << result.frames << " | - |\n";
  return out.str();
}

/// Recorded poses in place of the simulation.
struct Wish {
  std::string poses;
  std::string truth;
  std::string hand_eye;
};

nlohmann::ordered_json jsonOf(const StreamAccuracy& result) {
  return {{"std_mm", jsonOf(result.std_mm)},
          {"bias_mm", nullptr},
          {"rms_mm", result.rms_mm},
          {"fit_rms_mm", nullptr},
          {"turn_rms_deg", result.turn_rms_deg},
          {"standstills", result.standstills},
          {"poses", result.poses},
          {"clock_offset_ms", 1e3 * result.clock_offset_s},
          {"solved_hand_eye", result.solved_hand_eye},
          {"paper", {{"std_mm", experiments::paper::kStd_mm}}}};
}

std::string tableOf(const StreamAccuracy& result) {
  using experiments::paper::kStd_mm;
  std::ostringstream out;
  out << "# Accuracy of recorded poses\n\nThe object's place in the truth's base over " << result.standstills
      << " standstills (" << result.poses
      << " poses); where the object truly lies is not known, so that only "
      << "the spread is told.\n\n| | std x / y / z [mm] | rms [mm] |\n|---|---|---|\n| recorded | "
      << triple(result.std_mm) << " | " << fixedNumber(result.rms_mm, 3) << " |\n| the paper | " << kStd_mm[0]
      << " / " << kStd_mm[1] << " / " << kStd_mm[2] << " | - |\n";
  if (result.solved_hand_eye)
    out << "\nThe camera's place on the tracked tool and the clocks ("
        << fixedNumber(1e3 * result.clock_offset_s, 1) << " ms apart) were solved from the same poses.\n";
  return out.str();
}

ExperimentReport measureRecorded(const Wish& wish) {
  const auto camera = orRefuse(calibration::readPoseStream(wish.poses));
  const auto truth = orRefuse(calibration::readPoseStream(wish.truth));
  std::optional<RigidTransform> X_FC;
  if (!wish.hand_eye.empty()) X_FC = orRefuse(calibration::readHandEye(wish.hand_eye)).X_PC;
  const auto result = experiments::accuracyOfStreams(truth, camera, X_FC);
  if (!result) throw InputRefused(wish.truth + ": " + result.error());
  return {jsonOf(*result), tableOf(*result)};
}

ExperimentReport measureSimulated() {
  const auto result = experiments::measureAccuracy(resourceFolder());
  if (!result) throw InputRefused(result.error());
  return {jsonOf(*result), tableOf(*result)};
}

}  // namespace

void addExperimentAccuracy(CLI::App& experiment, Context& context) {
  const auto wish = std::make_shared<Wish>();
  CLI::App* command = addExperimentCommand(
      experiment, context, "accuracy",
      "Calibrate, then find a target from all over the paper's cuboid (section 3.2); or judge recorded poses",
      [wish] { return wish->poses.empty() ? measureSimulated() : measureRecorded(*wish); });
  auto* poses = command->add_option("--poses", wish->poses,
                                    "Recorded in place of simulated: poses.csv of `track` over standstills");
  auto* truth =
      command->add_option("--truth", wish->truth,
                          "What the robot, or a second tracker (see `listen`), said meanwhile: robot.csv");
  auto* hand_eye =
      command->add_option("--hand-eye", wish->hand_eye,
                          "hand_eye.yaml; without it the camera's place on the truth is solved too");
  poses->needs(truth);
  truth->needs(poses);
  hand_eye->needs(truth);
}

}  // namespace mirrorarm::cli
