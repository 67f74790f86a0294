#pragma once

#include <cstdint>
#include <span>

namespace mirrorarm::camera {

/// False when `bytes` are a PNG, JPEG, BMP or PGM/PPM file that was cut short or damaged: chunks that do not
/// add up to their checksums, a picture without an end, fewer bytes than the header promises. Other formats
/// pass. The decoders themselves would fill
/// the rest with grey or talk to standard error.
[[nodiscard]] bool isWhole(std::span<const std::uint8_t> bytes);

}  // namespace mirrorarm::camera
