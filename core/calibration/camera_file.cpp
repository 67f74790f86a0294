#include "core/calibration/camera_file.h"

#include "core/camera/camera_yaml.h"
#include "core/common/atomic_file.h"
#include "core/common/yaml.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::string_view kFormat = "mirrorarm/camera/1";

CameraRecord record(const YamlNode& root) {
  root.allowOnly(
      {"format", "image_size_px", "model", "fx_px", "fy_px", "cx_px", "cy_px", "distortion", "calibration"});
  CameraRecord read;
  read.camera =
      camera::CameraModel(camera::readIntrinsics(root, camera::readImageSize(root["image_size_px"])));
  if (!root.has("calibration")) return read;
  const auto note = root["calibration"];
  note.allowOnly({"date", "method", "rms_px"});
  if (note.has("date")) read.calibration.date = note["date"].text();
  if (note.has("method")) read.calibration.method = note["method"].text();
  if (note.has("rms_px")) read.calibration.rms_px = note["rms_px"].number();
  return read;
}

}  // namespace

FromFile<CameraRecord> readCameraFile(const std::filesystem::path& file) {
  return readYaml(file, kFormat, record);
}

Expected<void, std::string> writeCameraFile(const std::filesystem::path& file, const CameraRecord& record) {
  return writeWhole(file, [&record](std::ostream& out) {
    const auto& lens = record.camera.intrinsics();
    out << "format: " << kFormat << "\nimage_size_px: [" << lens.width_px << ", " << lens.height_px << "]\n";
    camera::writeIntrinsics(out, lens, "");
    out << "calibration:\n";
    if (!record.calibration.date.empty()) out << "  date: \"" << record.calibration.date << "\"\n";
    if (!record.calibration.method.empty()) out << "  method: \"" << record.calibration.method << "\"\n";
    out << "  rms_px: " << record.calibration.rms_px << '\n';
  });
}

}  // namespace mirrorarm::calibration
