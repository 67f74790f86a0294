#pragma once

#include <filesystem>

#include "core/camera/stereo_rig.h"
#include "core/common/file_error.h"

namespace mirrorarm::camera {

/// Reads `rig.yaml` (format mirrorarm/rig/1). Refused with the line and key: unknown format or key, missing
/// or non-finite numbers, a focal length or size that is not positive, a rotation that is not one,
/// no baseline. Of the optional map `calibration` the keys of CalibrationNote are read; others are notes for
/// people and pass.
[[nodiscard]] FromFile<StereoRig> readRig(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeRig(const std::filesystem::path& file, const StereoRig& rig);

}  // namespace mirrorarm::camera
