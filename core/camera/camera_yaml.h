#pragma once

#include <ostream>
#include <string_view>

#include "core/camera/camera_model.h"
#include "core/common/yaml.h"

namespace mirrorarm::camera {

struct ImageSize {
  int width_px = 0;
  int height_px = 0;
};

/// The list of width and height under a key `image_size_px`. Refuses by YamlProblem, as the next one.
[[nodiscard]] ImageSize readImageSize(const YamlNode& node);

/// One camera's keys model, fx_px, fy_px, cx_px, cy_px, distortion, as rig.yaml and camera.yaml hold them;
/// other keys of the map are the caller's.
[[nodiscard]] Intrinsics readIntrinsics(const YamlNode& node, const ImageSize& size);

/// Writes these keys, a line each behind `indent`; unused terms of the distortion are left out.
void writeIntrinsics(std::ostream& out, const Intrinsics& intrinsics, std::string_view indent);

}  // namespace mirrorarm::camera
