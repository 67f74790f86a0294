#include "core/calibration/camera_file.h"

#include <algorithm>

#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::calibration {
namespace {

using camera::Intrinsics;
using camera::LensModel;

constexpr std::string_view kFormat = "mirrorarm/camera/1";
constexpr long long kLargestSide_px = 65535;

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

void readDistortion(const YamlNode& node, Intrinsics& lens) {
  const auto numbers = node.numbers();
  const auto count = numbers.size();
  const bool is_brown_conrady = lens.model == LensModel::kBrownConrady;
  if (is_brown_conrady ? count != 2 && count != 4 && count != 5 : count != 4)
    node.refuse("does not hold the model's number of terms");
  std::copy(numbers.begin(), numbers.end(), lens.distortion.begin());
}

Intrinsics readLens(const YamlNode& root) {
  const auto model = camera::lensModelOf(root["model"].text());
  if (!model) root["model"].refuse("is neither brown_conrady nor kannala_brandt");
  Intrinsics lens;
  lens.model = *model;
  if (root["image_size_px"].size() != 2) root["image_size_px"].refuse("does not hold width and height");
  lens.width_px = side(root["image_size_px"][0]);
  lens.height_px = side(root["image_size_px"][1]);
  lens.fx_px = positive(root["fx_px"]);
  lens.fy_px = positive(root["fy_px"]);
  lens.cx_px = root["cx_px"].number();
  lens.cy_px = root["cy_px"].number();
  readDistortion(root["distortion"], lens);
  return lens;
}

CameraRecord record(const YamlNode& root) {
  root.allowOnly(
      {"format", "image_size_px", "model", "fx_px", "fy_px", "cx_px", "cy_px", "distortion", "calibration"});
  CameraRecord read;
  read.camera = camera::CameraModel(readLens(root));
  if (!root.has("calibration")) return read;
  const auto note = root["calibration"];
  note.allowOnly({"date", "method", "rms_px"});
  if (note.has("date")) read.calibration.date = note["date"].text();
  if (note.has("method")) read.calibration.method = note["method"].text();
  if (note.has("rms_px")) read.calibration.rms_px = note["rms_px"].number();
  return read;
}

std::size_t usedTerms(const Intrinsics& lens) {
  if (lens.model == LensModel::kKannalaBrandt) return 4;
  if (lens.distortion[4] != 0.0) return 5;
  return lens.distortion[2] != 0.0 || lens.distortion[3] != 0.0 ? 4 : 2;
}

void writeLens(std::ostream& out, const Intrinsics& lens) {
  out << "image_size_px: [" << lens.width_px << ", " << lens.height_px << "]\nmodel: " << name(lens.model)
      << "\nfx_px: " << lens.fx_px << "\nfy_px: " << lens.fy_px << "\ncx_px: " << lens.cx_px
      << "\ncy_px: " << lens.cy_px << "\ndistortion: ";
  for (std::size_t i = 0; i < usedTerms(lens); ++i) out << (i == 0 ? "[" : ", ") << lens.distortion[i];
  out << "]\n";
}

}  // namespace

FromFile<CameraRecord> readCameraFile(const std::filesystem::path& file) {
  return readYaml(file, kFormat, record);
}

Expected<void, std::string> writeCameraFile(const std::filesystem::path& file, const CameraRecord& record) {
  return writeWhole(file, [&record](std::ostream& out) {
    out << "format: " << kFormat << '\n';
    writeLens(out, record.camera.intrinsics());
    out << "calibration:\n";
    if (!record.calibration.date.empty()) out << "  date: \"" << record.calibration.date << "\"\n";
    if (!record.calibration.method.empty()) out << "  method: \"" << record.calibration.method << "\"\n";
    out << "  rms_px: " << record.calibration.rms_px << '\n';
  });
}

}  // namespace mirrorarm::calibration
