#pragma once

#include <filesystem>

#include "core/camera/camera_model.h"
#include "core/camera/stereo_rig.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// One camera's lens and where it came from.
struct CameraRecord {
  camera::CameraModel camera;
  camera::CalibrationNote calibration;  ///< without what only a rig has
};

/// Reads `camera.yaml` (format mirrorarm/camera/1): image_size_px and the keys of a camera in rig.yaml.
/// Refused with the line and key: what is unknown, missing, not finite or out of range. In the map
/// `calibration` unknown keys are notes for people and pass.
[[nodiscard]] FromFile<CameraRecord> readCameraFile(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeCameraFile(const std::filesystem::path& file,
                                                          const CameraRecord& record);

}  // namespace mirrorarm::calibration
