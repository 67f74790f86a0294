#include "core/camera/rig_file.h"

#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::camera {
namespace {

constexpr std::string_view kFormat = "mirrorarm/rig/1";
constexpr double kLargestSide_px = 65535;

double positive(const YamlNode& node) {
  const double value = node.number();
  if (value <= 0.0) node.refuse("is not positive");
  return value;
}

int side(const YamlNode& node) {
  const auto value = node.integer();
  if (value < 1 || value > kLargestSide_px) node.refuse("is not a number of pixels");
  return static_cast<int>(value);
}

LensModel readModel(const YamlNode& node) {
  const auto model = lensModelOf(node.text());
  if (!model) node.refuse("is neither brown_conrady nor kannala_brandt");
  return *model;
}

std::array<double, 5> readDistortion(const YamlNode& node, LensModel model) {
  const auto numbers = node.numbers();
  const auto count = numbers.size();
  if (model == LensModel::kBrownConrady && count != 2 && count != 4 && count != 5)
    node.refuse("does not hold k1 k2 [p1 p2 [k3]]");
  if (model == LensModel::kKannalaBrandt && count != 4) node.refuse("does not hold k1 k2 k3 k4");
  std::array<double, 5> distortion{};
  std::copy(numbers.begin(), numbers.end(), distortion.begin());
  return distortion;
}

CameraModel readCamera(const YamlNode& node, int width_px, int height_px) {
  node.allowOnly({"model", "fx_px", "fy_px", "cx_px", "cy_px", "distortion"});
  Intrinsics i;
  i.model = readModel(node["model"]);
  i.width_px = width_px;
  i.height_px = height_px;
  i.fx_px = positive(node["fx_px"]);
  i.fy_px = positive(node["fy_px"]);
  i.cx_px = node["cx_px"].number();
  i.cy_px = node["cy_px"].number();
  i.distortion = readDistortion(node["distortion"], i.model);
  return CameraModel(i);
}

RigidTransform readRightFromLeft(const YamlNode& node) {
  node.allowOnly({"rotation_xyzw", "translation_m"});
  const auto translation = node["translation_m"];
  if (translation.vector3().norm() <= 0.0) translation.refuse("is zero: both cameras stand in one place");
  return makeTransform(node["rotation_xyzw"].quaternion(), translation.vector3());
}

CalibrationNote readNote(const YamlNode& node) {
  CalibrationNote note;
  const auto text = [&](std::string_view key) { return node.has(key) ? node[key].text() : std::string(); };
  const auto number = [&](std::string_view key) { return node.has(key) ? node[key].number() : 0.0; };
  note.date = text("date");
  note.method = text("method");
  note.rms_px = number("rms_px");
  note.hold_out_epipolar_px = number("hold_out_epipolar_px");
  note.left_serial = text("left_serial");
  note.right_serial = text("right_serial");
  return note;
}

StereoRig readRoot(const YamlNode& root) {
  root.allowOnly({"format", "image_size_px", "left", "right", "right_from_left", "calibration"});
  const auto size = root["image_size_px"];
  if (size.size() != 2) size.refuse("does not hold width and height");
  const int width_px = side(size[0]);
  const int height_px = side(size[1]);
  StereoRig rig;
  rig.left = readCamera(root["left"], width_px, height_px);
  rig.right = readCamera(root["right"], width_px, height_px);
  rig.X_RC = readRightFromLeft(root["right_from_left"]);
  if (root.has("calibration")) rig.calibration = readNote(root["calibration"]);
  return rig;
}

template <class Numbers>
void writeList(std::ostream& out, const Numbers& numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out << (i == 0 ? "[" : ", ") << numbers[i];
  out << "]\n";
}

std::size_t usedTerms(const Intrinsics& i) {
  if (i.model == LensModel::kKannalaBrandt) return 4;
  if (i.distortion[4] != 0.0) return 5;
  return i.distortion[2] != 0.0 || i.distortion[3] != 0.0 ? 4 : 2;
}

void writeCamera(std::ostream& out, std::string_view key, const Intrinsics& i) {
  out << key << ":\n  model: " << name(i.model) << "\n  fx_px: " << i.fx_px << "\n  fy_px: " << i.fy_px
      << "\n  cx_px: " << i.cx_px << "\n  cy_px: " << i.cy_px << "\n  distortion: ";
  writeList(out, i.distortion, usedTerms(i));
}

void writeText(std::ostream& out, std::string_view key, std::string_view text) {
  if (text.empty()) return;
  out << "  " << key << ": \"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out << '\\';
    out << (static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  }
  out << "\"\n";
}

void writeNote(std::ostream& out, const CalibrationNote& note) {
  out << "calibration:\n  rms_px: " << note.rms_px
      << "\n  hold_out_epipolar_px: " << note.hold_out_epipolar_px << "\n";
  writeText(out, "date", note.date);
  writeText(out, "method", note.method);
  writeText(out, "left_serial", note.left_serial);
  writeText(out, "right_serial", note.right_serial);
}

}  // namespace

FromFile<StereoRig> readRig(const std::filesystem::path& file) { return readYaml(file, kFormat, readRoot); }

Expected<void, std::string> writeRig(const std::filesystem::path& file, const StereoRig& rig) {
  return writeWhole(file, [&](std::ostream& out) {
    const auto& left = rig.left.intrinsics();
    out << "format: " << kFormat << "\nimage_size_px: [" << left.width_px << ", " << left.height_px << "]\n";
    writeCamera(out, "left", left);
    writeCamera(out, "right", rig.right.intrinsics());
    out << "right_from_left:\n  rotation_xyzw: ";
    writeList(out, rotationOf(rig.X_RC).coeffs(), 4);
    out << "  translation_m: ";
    writeList(out, rig.X_RC.translation(), 3);
    writeNote(out, rig.calibration);
  });
}

}  // namespace mirrorarm::camera
