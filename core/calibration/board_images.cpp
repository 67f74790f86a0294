#include "core/calibration/board_images.h"

#include <optional>

#include "core/calibration/board_finder.h"
#include "core/calibration/image_list.h"
#include "core/camera/image_file.h"

namespace mirrorarm::calibration {
namespace {

/// Reads images one after the other and holds them to one size.
class Reader {
 public:
  explicit Reader(const Board& board) : board_(board) {}

  [[nodiscard]] FromFile<std::optional<Sighting>> find(const std::filesystem::path& file) {
    const auto image = camera::readImage(file);
    if (!image) return unexpected(image.error());
    const ImageSize size{image->width(), image->height()};
    if (first_.empty()) {
      first_ = file;
      size_ = size;
    }
    if (!(size == size_))
      return unexpected(
          FileError{file, 0, "is " + text(size) + " where " + first_.string() + " is " + text(size_)});
    const auto sighting = findBoard(image->view(), board_);
    return sighting ? std::optional(*sighting) : std::nullopt;
  }

  [[nodiscard]] ImageSize size() const { return size_; }

 private:
  static std::string text(ImageSize size) {
    return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
  }
  Board board_;
  std::filesystem::path first_;
  ImageSize size_;
};

/// Adds the view of one or two images, or their names to those without a board.
FromFile<void> addView(Reader& reader, const std::vector<std::filesystem::path>& files, const Board& board,
                       BoardImages& images) {
  BoardView view{files.front().filename().string(), {}};
  bool is_whole = true;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const auto sighting = reader.find(files[k]);
    if (!sighting) return unexpected(sighting.error());
    if (!*sighting) {
      images.not_found.push_back(files[k].filename().string());
      is_whole = false;
    } else if (is_whole) {
      view.seen[k] = k == 0 ? **sighting : orderedLike(view.seen[0], **sighting, board);
    }
  }
  if (is_whole) images.views.push_back(std::move(view));
  return {};
}

}  // namespace

FromFile<BoardImages> readBoardImages(const std::filesystem::path& folder, const Board& board) {
  const auto files = listImages(folder);
  if (!files) return unexpected(files.error());
  Reader reader(board);
  BoardImages images;
  for (const auto& file : *files)
    if (const auto added = addView(reader, {file}, board, images); !added) return unexpected(added.error());
  images.size = reader.size();
  return images;
}

FromFile<BoardImages> readBoardImagePairs(const std::filesystem::path& left,
                                          const std::filesystem::path& right, const Board& board) {
  const auto pairs = listImagePairs(left, right);
  if (!pairs) return unexpected(pairs.error());
  Reader reader(board);
  BoardImages images;
  for (const auto& [left_file, right_file] : *pairs)
    if (const auto added = addView(reader, {left_file, right_file}, board, images); !added)
      return unexpected(added.error());
  images.size = reader.size();
  return images;
}

}  // namespace mirrorarm::calibration
