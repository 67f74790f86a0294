#pragma once

#include <filesystem>
#include <string>

#include "core/camera/image.h"
#include "core/common/file_error.h"

namespace mirrorarm::camera {

/// Reads PNG, JPEG, BMP, TIFF or PGM as 8-bit grey (colour is weighted to grey). Refused: a missing, broken
/// or empty file, and 16-bit images, whose scale nobody declared.
[[nodiscard]] FromFile<GreyImage> readImage(const std::filesystem::path& file);

/// Writes `image`, format by the file's ending. The error is the reason.
[[nodiscard]] Expected<void, std::string> writeImage(const std::filesystem::path& file,
                                                     const GreyImage& image);

}  // namespace mirrorarm::camera
