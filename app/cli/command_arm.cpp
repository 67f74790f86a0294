#include <array>
#include <iostream>
#include <memory>
#include <numbers>

#include "app/cli/commands.h"
#include "core/common/calendar.h"
#include "core/tracking/arm_file.h"
#include "core/tracking/pose_table.h"

namespace mirrorarm::cli {
namespace {

using tracking::ArmCalibrationError;
using tracking::ArmFrame;

constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

struct Options {
  std::string side, upper_arm, forearm, thorax;
  std::filesystem::path posture, flexion, rotation, circles, out;
};

/// The frames in which all of the arm's targets were tracked.
std::vector<ArmFrame> readMovement(const std::filesystem::path& file, const Options& options) {
  std::vector<ArmFrame> frames;
  for (const auto& poses : orRefuse(tracking::readTrackedPoses(file))) {
    const auto upper_arm = poses.find(options.upper_arm), forearm = poses.find(options.forearm);
    if (upper_arm == poses.end() || forearm == poses.end()) continue;
    ArmFrame frame;
    frame.X_CU = upper_arm->second;
    frame.X_CF = forearm->second;
    if (!options.thorax.empty()) {
      const auto thorax = poses.find(options.thorax);
      if (thorax == poses.end()) continue;
      frame.X_CR = thorax->second;
    }
    frames.push_back(frame);
  }
  if (frames.empty()) throw InputRefused(file.string() + ": no frame shows all targets of the arm tracked");
  return frames;
}

struct Refusal {
  const std::filesystem::path& file;
  std::string reason;
};

Refusal refusalOf(ArmCalibrationError error, const Options& options) {
  switch (error) {
    case ArmCalibrationError::kNoPosture:
      return {options.posture, "holds no reference posture"};
    case ArmCalibrationError::kSmallFlexion:
      return {options.flexion, "bends the elbow by less than 50 degrees, or in fewer than 10 frames"};
    case ArmCalibrationError::kFlexionNotHinge:
      return {options.flexion, "turns about more than one axis: loose targets, or no elbow flexion"};
    case ArmCalibrationError::kSmallRotation:
      return {options.rotation, "turns the forearm by less than 50 degrees, or in fewer than 10 frames"};
    case ArmCalibrationError::kRotationNotHinge:
      return {options.rotation, "turns about more than one axis: loose targets, or no forearm rotation"};
    case ArmCalibrationError::kRotationReversed:
      return {options.rotation, "does not begin palm up, or the arm is of the other side"};
    case ArmCalibrationError::kSmallCircles:
      return {options.circles, "swings the arm too little, in a plane only, or in fewer than 10 frames"};
    case ArmCalibrationError::kShoulderMoved:
      return {options.circles, "turns about no point: the trunk moved, or targets are loose"};
    case ArmCalibrationError::kUpperArmLength:
      return {options.circles, "puts the shoulder nearer than 0.15 m to the elbow or beyond 0.5 m"};
  }
  return {options.out, "cannot be made"};
}

nlohmann::ordered_json resultOf(const tracking::ArmRecord& arm) {
  const auto& quality = arm.quality;
  return {{"side", id(arm.model.side)},
          {"reference", arm.model.thorax.empty() ? "camera" : arm.model.thorax},
          {"flexion_range_deg", kRadianInDegrees * quality.flexion_range_rad},
          {"flexion_across_deg", kRadianInDegrees * quality.flexion_across_rad},
          {"rotation_range_deg", kRadianInDegrees * quality.rotation_range_rad},
          {"rotation_across_deg", kRadianInDegrees * quality.rotation_across_rad},
          {"shoulder_rms_mm", 1e3 * quality.shoulder_rms_m},
          {"upper_arm_mm", 1e3 * quality.upper_arm_m}};
}

void findBones(const Options& options, Context& context) {
  const tracking::ArmMovements movements{
      readMovement(options.posture, options), readMovement(options.flexion, options),
      readMovement(options.rotation, options), readMovement(options.circles, options)};
  const auto side = options.side == "left" ? tracking::Side::kLeft : tracking::Side::kRight;
  auto calibrated = tracking::calibrateArm(movements, side);
  if (!calibrated) {
    const Refusal refusal = refusalOf(calibrated.error(), options);
    throw InputRefused(refusal.file.string() + ": " + refusal.reason);
  }
  tracking::ArmRecord arm{calibrated->model, isoUtcNow(), calibrated->quality};
  arm.model.upper_arm = options.upper_arm;
  arm.model.forearm = options.forearm;
  arm.model.thorax = options.thorax;
  orFail(tracking::writeArm(options.out, arm));
  context.result = resultOf(arm);
  if (!context.json)
    std::cout << "upper arm of " << 1e3 * arm.quality.upper_arm_m << " mm, elbow bent by "
              << kRadianInDegrees * arm.quality.flexion_range_rad << " degrees, " << options.out.string()
              << "\n";
}

}  // namespace

void addArm(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(
      app, context, "arm", "Find the arm's bones in its targets, from movements that track has followed",
      "mirrorarm-cli arm --side right --upper-arm upper --forearm forearm --posture posture.csv "
      "--flexion flexion.csv --rotation rotation.csv --circles circles.csv --out arm.yaml");
  const auto options = std::make_shared<Options>();
  command->add_option("--side", options->side, "left or right")
      ->required()
      ->check(CLI::IsMember({"left", "right"}));
  command->add_option("--upper-arm", options->upper_arm, "Name of the target on the upper arm")->required();
  command->add_option("--forearm", options->forearm, "Name of the target on the forearm")->required();
  command->add_option("--thorax", options->thorax,
                      "Name of a target on the trunk; else the camera must rest");
  command
      ->add_option("--posture", options->posture, "Poses: upper arm hanging, elbow at 90 degrees, hand ahead")
      ->required();
  command->add_option("--flexion", options->flexion, "Poses: elbow bent and stretched, straight at first")
      ->required();
  command->add_option("--rotation", options->rotation, "Poses: bent forearm turned, palm up at first")
      ->required();
  command->add_option("--circles", options->circles, "Poses: arm swung in a cone, trunk still")->required();
  command->add_option("--out", options->out, "Arm to write")->required();
  command->callback([options, &context] { findBones(*options, context); });
}

}  // namespace mirrorarm::cli
