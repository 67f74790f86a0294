#pragma once

#include <cstdint>

#include "core/camera/image.h"
#include "core/common/time.h"

namespace mirrorarm::camera {

/// One synchronised pair of raw images. Cheap to copy: the pixels are shared.
struct StereoFrame {
  GreyImage left;
  GreyImage right;
  TimePoint exposed_at{};      ///< middle of the exposure, not arrival in the PC
  Seconds exposure{0.0};       ///< how long the sensors took light
  std::uint64_t sequence = 0;  ///< counts the camera's frames from 0; a gap is a lost frame
};

}  // namespace mirrorarm::camera
