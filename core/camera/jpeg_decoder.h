#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/camera/image.h"
#include "core/common/expected.h"

namespace mirrorarm::camera {

/// Decodes a JPEG picture as grey. Refused with the reason: damaged data, which other decoders fill up or
/// talk about on standard error, more than `most_pixels`, and pictures in printing colours.
[[nodiscard]] Expected<GreyImage, std::string> decodeJpeg(std::span<const std::uint8_t> bytes,
                                                          std::uint64_t most_pixels);

}  // namespace mirrorarm::camera
