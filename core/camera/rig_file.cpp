#include "core/camera/rig_file.h"

#include "core/camera/camera_yaml.h"
#include "core/camera/note_yaml.h"
#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::camera {
namespace {

constexpr std::string_view kFormat = "mirrorarm/rig/1";
CameraModel readCamera(const YamlNode& node, const ImageSize& size) {
  node.allowOnly({"model", "fx_px", "fy_px", "cx_px", "cy_px", "distortion"});
  return CameraModel(readIntrinsics(node, size));
}

RigidTransform readRightFromLeft(const YamlNode& node) {
  node.allowOnly({"rotation_xyzw", "translation_m"});
  const auto translation = node["translation_m"];
  if (translation.vector3().norm() <= 0.0) translation.refuse("is zero: both cameras stand in one place");
  return makeTransform(node["rotation_xyzw"].quaternion(), translation.vector3());
}

StereoRig readRoot(const YamlNode& root) {
  root.allowOnly({"format", "image_size_px", "left", "right", "right_from_left", "calibration"});
  const auto size = readImageSize(root["image_size_px"]);
  StereoRig rig;
  rig.left = readCamera(root["left"], size);
  rig.right = readCamera(root["right"], size);
  rig.X_RC = readRightFromLeft(root["right_from_left"]);
  if (root.has("calibration")) rig.calibration = readNote(root["calibration"]);
  return rig;
}

template <class Numbers>
void writeList(std::ostream& out, const Numbers& numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out << (i == 0 ? "[" : ", ") << numbers[i];
  out << "]\n";
}

}  // namespace

FromFile<StereoRig> readRig(const std::filesystem::path& file) { return readYaml(file, kFormat, readRoot); }

Expected<void, std::string> writeRig(const std::filesystem::path& file, const StereoRig& rig) {
  return writeWhole(file, [&](std::ostream& out) {
    const auto& left = rig.left.intrinsics();
    out << "format: " << kFormat << "\nimage_size_px: [" << left.width_px << ", " << left.height_px << "]\n";
    out << "left:\n";
    writeIntrinsics(out, left, "  ");
    out << "right:\n";
    writeIntrinsics(out, rig.right.intrinsics(), "  ");
    out << "right_from_left:\n  rotation_xyzw: ";
    writeList(out, rotationOf(rig.X_RC).coeffs(), 4);
    out << "  translation_m: ";
    writeList(out, rig.X_RC.translation(), 3);
    writeNote(out, rig.calibration, NoteOf::kRig);
  });
}

}  // namespace mirrorarm::camera
