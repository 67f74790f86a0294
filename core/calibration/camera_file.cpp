#include "core/calibration/camera_file.h"

#include "core/camera/camera_yaml.h"
#include "core/camera/note_yaml.h"
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
  if (root.has("calibration")) read.calibration = camera::readNote(root["calibration"]);
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
    camera::writeNote(out, record.calibration, camera::NoteOf::kOneCamera);
  });
}

}  // namespace mirrorarm::calibration
