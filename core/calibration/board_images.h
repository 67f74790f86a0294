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
  std::vector<BoardView> views;  ///< those with enough of the board, in the order of their names
  /// Names of images without the board: not whole, or of a dot plate less than half.
  std::vector<std::string> not_found;
  std::vector<std::string> larger;  ///< names of images with a board that goes on beyond the wished size
  ImageSize size;
};

/// What to say of the images that gave nothing, with the reasons; empty when there is none. Where no image
/// shows the board, that it may be smaller than the wished one is named too.
[[nodiscard]] std::string leftOut(const BoardImages& images);

/// Finds the board in every image of `images`: a folder, or a path whose last part holds one '*'
/// ("left*.png"). Refused, with the file and the remedy: no images, an image that cannot be read or is of
/// another size than the first, boards of which more are larger than the wished one than are not.
[[nodiscard]] FromFile<BoardImages> readBoardImages(const std::filesystem::path& images, const Board& board);

/// The same for two cameras. Images are partners when their names end in the same number ("left07", "r_7")
/// or, without a number, are equal but for the words left and right. One folder with both cameras' images may
/// be given twice: those with `left` in the name and those with `right` are taken. Also refused: an image
/// without a partner, two with one number, unequal counts. A view is used where both cameras saw the whole
/// board, or of a dot plate half of the points each.
[[nodiscard]] FromFile<BoardImages> readBoardImagePairs(const std::filesystem::path& left,
                                                        const std::filesystem::path& right,
                                                        const Board& board);

}  // namespace mirrorarm::calibration
