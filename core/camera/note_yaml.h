#pragma once

#include <ostream>

#include "core/camera/stereo_rig.h"
#include "core/common/yaml.h"

namespace mirrorarm::camera {

/// The map `calibration` of rig.yaml and camera.yaml. Keys that are not CalibrationNote's are notes for
/// people and pass; what is there but of the wrong kind is refused by YamlProblem.
[[nodiscard]] CalibrationNote readNote(const YamlNode& node);

enum class NoteOf { kOneCamera, kRig };
/// Writes it; what is unknown is left out.
void writeNote(std::ostream& out, const CalibrationNote& note, NoteOf of);

}  // namespace mirrorarm::camera
