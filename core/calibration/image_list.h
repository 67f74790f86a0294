#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// Files with the ending of an image, sorted by name, in a folder or matching a path whose last part holds
/// one
/// '*'. Refused: nothing there.
[[nodiscard]] FromFile<std::vector<std::filesystem::path>> listImages(const std::filesystem::path& images);

using ImagePair = std::pair<std::filesystem::path, std::filesystem::path>;  ///< left, right

/// Partners by number or name, see readBoardImagePairs.
[[nodiscard]] FromFile<std::vector<ImagePair>> listImagePairs(const std::filesystem::path& left,
                                                              const std::filesystem::path& right);

}  // namespace mirrorarm::calibration
