#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// The views that a folder of images gave.
struct BoardImages {
  std::vector<BoardView> views;        ///< those with the whole board, in the order of their names
  std::vector<std::string> not_found;  ///< names of images where the board was not found whole
  ImageSize size;
};

/// Finds the board in every image of `images`: a folder, or a path whose last part holds one '*'
/// ("left*.png"). Refused, with the file: no images, an image that cannot be read or is of another size than
/// the first.
[[nodiscard]] FromFile<BoardImages> readBoardImages(const std::filesystem::path& images, const Board& board);

/// The same for two cameras. Images are partners when their names end in the same number ("left07", "r_7")
/// or, without a number, are equal but for the words left and right. One folder with both cameras' images may
/// be given twice: those with `left` in the name and those with `right` are taken. Also refused: an image
/// without a partner, two with one number, unequal counts. A view is used where both cameras saw the whole
/// board.
[[nodiscard]] FromFile<BoardImages> readBoardImagePairs(const std::filesystem::path& left,
                                                        const std::filesystem::path& right,
                                                        const Board& board);

}  // namespace mirrorarm::calibration
