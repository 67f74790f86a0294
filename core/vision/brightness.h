#pragma once

#include <cstdint>

#include "core/camera/image.h"
#include "core/vision/region.h"

namespace mirrorarm::vision {

/// An image in which what is looked for is bright: the image itself, or its negative for dark dots.
struct Brightness {
  camera::ImageView image;
  std::uint8_t flip = 0;  ///< 0, or 255 for the negative

  [[nodiscard]] std::uint8_t at(int x, int y) const {
    return static_cast<std::uint8_t>(image.at(x, y) ^ flip);
  }
  [[nodiscard]] Region frame() const { return {0, 0, image.width_px - 1, image.height_px - 1}; }
};

}  // namespace mirrorarm::vision
