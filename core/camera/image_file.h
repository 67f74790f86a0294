#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/camera/image.h"
#include "core/common/file_error.h"

namespace mirrorarm::camera {

/// No camera of a workstation delivers as many: a file that claims more is wrong or means harm.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 27;

/// Reads PNG, JPEG, BMP, TIFF or binary PGM as 8-bit grey: colour is weighted to grey, transparency has no
/// say. Refused: a missing, broken or empty file, other formats, images of more than kMostPixels by their own
/// word, and deeper ones than 8 bits, whose scale nobody declared.
[[nodiscard]] FromFile<GreyImage> readImage(const std::filesystem::path& file);

/// Writes `image`, format by the file's ending. The error is the reason.
[[nodiscard]] Expected<void, std::string> writeImage(const std::filesystem::path& file,
                                                     const GreyImage& image);

}  // namespace mirrorarm::camera
