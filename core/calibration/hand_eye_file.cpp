#include "core/calibration/hand_eye_file.h"

#include <numbers>

#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::string_view kFormat = "mirrorarm/hand-eye/1";
constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

constexpr std::string_view keyOf(CameraMount mount) {
  return mount == CameraMount::kInHand ? "flange_from_camera" : "base_from_camera";
}

RigidTransform pose(const YamlNode& node) {
  node.allowOnly({"translation_m", "rotation_xyzw"});
  return makeTransform(node["rotation_xyzw"].quaternion(), node["translation_m"].vector3());
}

HandEyeNote note(const YamlNode& node) {
  node.allowOnly({"date", "method", "pairs", "residual_mm", "residual_deg", "sigma_mm"});
  HandEyeNote note;
  if (node.has("date")) note.date = node["date"].text();
  if (node.has("method")) note.method = node["method"].text();
  if (node.has("pairs")) note.pairs = static_cast<int>(node["pairs"].integer());
  if (node.has("residual_mm")) note.rms_m = node["residual_mm"].number() / 1e3;
  if (node.has("residual_deg")) note.rms_rad = node["residual_deg"].number() / kRadianInDegrees;
  if (node.has("sigma_mm")) note.sigma_m = node["sigma_mm"].number() / 1e3;
  return note;
}

HandEye handEye(const YamlNode& root) {
  root.allowOnly({"format", "flange_from_camera", "base_from_camera", "calibration"});
  HandEye read;
  if (root.has(keyOf(CameraMount::kToHand))) {
    if (root.has(keyOf(CameraMount::kInHand))) root.refuse("holds flange_from_camera and base_from_camera");
    read.mount = CameraMount::kToHand;
  }
  read.X_PC = pose(root[keyOf(read.mount)]);
  if (root.has("calibration")) read.calibration = note(root["calibration"]);
  return read;
}

void writeNote(std::ostream& out, const HandEyeNote& note) {
  out << "calibration:\n";
  if (!note.date.empty()) out << "  date: \"" << note.date << "\"\n";
  if (!note.method.empty()) out << "  method: \"" << note.method << "\"\n";
  out << "  pairs: " << note.pairs << "\n  residual_mm: " << note.rms_m * 1e3
      << "\n  residual_deg: " << note.rms_rad * kRadianInDegrees << '\n';
  if (note.sigma_m) out << "  sigma_mm: " << *note.sigma_m * 1e3 << '\n';
}

}  // namespace

FromFile<HandEye> readHandEye(const std::filesystem::path& file) { return readYaml(file, kFormat, handEye); }

Expected<void, std::string> writeHandEye(const std::filesystem::path& file, const HandEye& hand_eye) {
  return writeWhole(file, [&hand_eye](std::ostream& out) {
    const Eigen::Vector3d p = hand_eye.X_PC.translation();
    const auto q = rotationOf(hand_eye.X_PC);
    out << "format: " << kFormat << '\n'
        << keyOf(hand_eye.mount) << ":\n"
        << "  translation_m: [" << p.x() << ", " << p.y() << ", " << p.z() << "]\n"
        << "  rotation_xyzw: [" << q.x() << ", " << q.y() << ", " << q.z() << ", " << q.w() << "]\n";
    writeNote(out, hand_eye.calibration);
  });
}

}  // namespace mirrorarm::calibration
