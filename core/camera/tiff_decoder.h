#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/camera/image.h"
#include "core/common/expected.h"

namespace mirrorarm::camera {

/// Decodes the first picture of a TIFF file as grey, without a word on standard error. Refused with the
/// reason: damaged data, pixels deeper than 8 bits, more than `most_pixels`.
[[nodiscard]] Expected<GreyImage, std::string> decodeTiff(std::span<const std::uint8_t> bytes,
                                                          std::uint64_t most_pixels);

}  // namespace mirrorarm::camera
