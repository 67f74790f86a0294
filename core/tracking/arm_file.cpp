#include "core/tracking/arm_file.h"

#include <numbers>
#include <ostream>
#include <sstream>

#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::string_view kFormat = "mirrorarm/arm/1";
constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

Side readSide(const YamlNode& node) {
  const std::string text = node.text();
  if (text == id(Side::kLeft)) return Side::kLeft;
  if (text == id(Side::kRight)) return Side::kRight;
  node.refuse("is neither left nor right");
}

Eigen::Matrix3d rotation(const YamlNode& node) { return node.quaternion().toRotationMatrix(); }

void readBones(const YamlNode& root, ArmModel& model) {
  const YamlNode upper = root["upper_arm"], fore = root["forearm"];
  upper.allowOnly({"target", "humerus_xyzw", "shoulder_m", "elbow_m"});
  fore.allowOnly({"target", "forearm_xyzw"});
  model.upper_arm = upper["target"].text();
  model.R_Uh = rotation(upper["humerus_xyzw"]);
  model.shoulder_U = upper["shoulder_m"].vector3();
  model.elbow_U = upper["elbow_m"].vector3();
  model.forearm = fore["target"].text();
  model.R_Ff = rotation(fore["forearm_xyzw"]);
}

void readReference(const YamlNode& root, ArmModel& model) {
  const YamlNode reference = root["reference"];
  reference.allowOnly({"target", "thorax_xyzw"});
  if (reference.has("target")) model.thorax = reference["target"].text();
  model.R_Rt = rotation(reference["thorax_xyzw"]);
}

void checkNames(const YamlNode& root, const ArmModel& model) {
  if (model.upper_arm.empty() || model.forearm.empty()) root.refuse("names no target on a part of the arm");
  if (model.upper_arm == model.forearm || model.upper_arm == model.thorax || model.forearm == model.thorax)
    root.refuse("names one target twice");
}

void readNote(const YamlNode& node, ArmRecord& arm) {
  node.allowOnly({"date", "flexion_range_deg", "flexion_across_deg", "rotation_range_deg",
                  "rotation_across_deg", "shoulder_rms_mm", "upper_arm_mm"});
  if (node.has("date")) arm.date = node["date"].text();
  const auto number = [&node](std::string_view key, double unit, double& value) {
    if (node.has(key)) value = node[key].number() / unit;
  };
  ArmCalibrationQuality& quality = arm.quality;
  number("flexion_range_deg", kRadianInDegrees, quality.flexion_range_rad);
  number("flexion_across_deg", kRadianInDegrees, quality.flexion_across_rad);
  number("rotation_range_deg", kRadianInDegrees, quality.rotation_range_rad);
  number("rotation_across_deg", kRadianInDegrees, quality.rotation_across_rad);
  number("shoulder_rms_mm", 1e3, quality.shoulder_rms_m);
  number("upper_arm_mm", 1e3, quality.upper_arm_m);
}

ArmRecord parse(const YamlNode& root) {
  root.allowOnly({"format", "side", "upper_arm", "forearm", "reference", "calibration"});
  ArmRecord arm;
  arm.model.side = readSide(root["side"]);
  readBones(root, arm.model);
  readReference(root, arm.model);
  checkNames(root, arm.model);
  if (root.has("calibration")) readNote(root["calibration"], arm);
  return arm;
}

std::string list(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out.precision(12);
  out << '[' << v.x() << ", " << v.y() << ", " << v.z() << ']';
  return out.str();
}

std::string list(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = rotationOf(makeTransform(R, Eigen::Vector3d::Zero()));
  std::ostringstream out;
  out.precision(12);
  out << '[' << q.x() << ", " << q.y() << ", " << q.z() << ", " << q.w() << ']';
  return out.str();
}

void write(std::ostream& out, const ArmRecord& arm) {
  const ArmModel& model = arm.model;
  out << "format: " << kFormat << "\nside: " << id(model.side) << "\nupper_arm:\n  target: '"
      << model.upper_arm << "'\n  humerus_xyzw: " << list(model.R_Uh)
      << "\n  shoulder_m: " << list(model.shoulder_U) << "\n  elbow_m: " << list(model.elbow_U)
      << "\nforearm:\n  target: '" << model.forearm << "'\n  forearm_xyzw: " << list(model.R_Ff)
      << "\nreference:\n";
  if (!model.thorax.empty()) out << "  target: '" << model.thorax << "'\n";
  out << "  thorax_xyzw: " << list(model.R_Rt) << "\ncalibration:\n";
  if (!arm.date.empty()) out << "  date: \"" << arm.date << "\"\n";
  const ArmCalibrationQuality& quality = arm.quality;
  out << "  flexion_range_deg: " << kRadianInDegrees * quality.flexion_range_rad
      << "\n  flexion_across_deg: " << kRadianInDegrees * quality.flexion_across_rad
      << "\n  rotation_range_deg: " << kRadianInDegrees * quality.rotation_range_rad
      << "\n  rotation_across_deg: " << kRadianInDegrees * quality.rotation_across_rad
      << "\n  shoulder_rms_mm: " << 1e3 * quality.shoulder_rms_m
      << "\n  upper_arm_mm: " << 1e3 * quality.upper_arm_m << '\n';
}

}  // namespace

FromFile<ArmRecord> readArm(const std::filesystem::path& file) { return readYaml(file, kFormat, parse); }

Expected<void, std::string> writeArm(const std::filesystem::path& file, const ArmRecord& arm) {
  return writeWhole(file, [&arm](std::ostream& out) { write(out, arm); });
}

}  // namespace mirrorarm::tracking
