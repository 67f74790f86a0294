#include "core/calibration/board_images.h"

#include <string>
#include <utility>

#include "core/calibration/board_finder.h"
#include "core/calibration/image_list.h"
#include "core/camera/image_file.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kLeastShare = 0.5;  // of a board's points, for a view that is used

using Path = std::filesystem::path;

std::string text(ImageSize size) {
  return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
}

std::string joined(const std::vector<std::string>& names) {
  std::string line;
  for (const auto& name : names) line += (line.empty() ? "" : ", ") + name;
  return line;
}

/// Reads images one after the other, holds them to one size and gathers what they show.
class Gatherer {
 public:
  explicit Gatherer(const Board& board) : board_(board) {}

  /// The view of one or two images, or their names among those without the board.
  [[nodiscard]] FromFile<void> add(const std::vector<Path>& files) {
    BoardView view{files.front().filename().string(), {}};
    bool is_seen = true;
    for (std::size_t k = 0; k < files.size(); ++k) {
      const auto sighting = find(files[k]);
      if (!sighting) return unexpected(sighting.error());
      is_seen = is_seen && !(*sighting).empty();
      if (is_seen) view.seen[k] = k == 0 ? *sighting : orderedLike(view.seen[0], *sighting, board_);
    }
    if (is_seen) images_.views.push_back(std::move(view));
    return {};
  }

  /// All of them, unless the board is another one.
  [[nodiscard]] FromFile<BoardImages> finish() {
    if (images_.larger.size() <= found_) return std::move(images_);
    return unexpected(FileError{first_larger_, 0,
                                "shows a board that goes on beyond " + std::to_string(board_.columns) + "x" +
                                    std::to_string(board_.rows) + " points, as do " +
                                    std::to_string(images_.larger.size()) + " of " + std::to_string(read_) +
                                    " images: give the size of the whole board"});
  }

 private:
  /// Empty where too little of the board is seen.
  [[nodiscard]] FromFile<Sighting> find(const Path& file) {
    const auto image = camera::readImage(file);
    if (!image) return unexpected(image.error());
    const ImageSize size{image->width(), image->height()};
    if (read_++ == 0) {
      first_ = file;
      images_.size = size;
    }
    if (!(size == images_.size))
      return unexpected(FileError{file, 0,
                                  "is " + text(size) + " where " + first_.string() + " is " +
                                      text(images_.size) + ": take all images with one size"});
    auto sighting = findBoard(image->view(), board_);
    if (!sighting) {
      miss(file, sighting.error());
      return Sighting{};
    }
    if (static_cast<double>(sighting->size()) < kLeastShare * board_.columns * board_.rows) {
      miss(file, BoardMiss::kNotFound);
      return Sighting{};
    }
    ++found_;
    return *std::move(sighting);
  }

  void miss(const Path& file, BoardMiss why) {
    if (why == BoardMiss::kLargerBoard && images_.larger.empty()) first_larger_ = file;
    auto& names = why == BoardMiss::kLargerBoard ? images_.larger : images_.not_found;
    names.push_back(file.filename().string());
  }

  Board board_;
  BoardImages images_;
  Path first_, first_larger_;
  std::size_t read_ = 0, found_ = 0;
};

}  // namespace

std::string leftOut(const BoardImages& images) {
  std::string line;
  if (!images.not_found.empty())
    line = std::string(reason(BoardMiss::kNotFound)) + " (" + joined(images.not_found) + ")";
  if (images.views.empty() && images.larger.empty() && !line.empty())
    line += "; a board with fewer columns or rows than the size asked for looks like none";
  if (images.larger.empty()) return line;
  if (!line.empty()) line += "; ";
  return line + std::string(reason(BoardMiss::kLargerBoard)) + " (" + joined(images.larger) + ")";
}

FromFile<BoardImages> readBoardImages(const Path& folder, const Board& board) {
  const auto files = listImages(folder);
  if (!files) return unexpected(files.error());
  Gatherer gatherer(board);
  for (const auto& file : *files)
    if (const auto added = gatherer.add({file}); !added) return unexpected(added.error());
  return gatherer.finish();
}

FromFile<BoardImages> readBoardImagePairs(const Path& left, const Path& right, const Board& board) {
  const auto pairs = listImagePairs(left, right);
  if (!pairs) return unexpected(pairs.error());
  Gatherer gatherer(board);
  for (const auto& [left_file, right_file] : *pairs)
    if (const auto added = gatherer.add({left_file, right_file}); !added) return unexpected(added.error());
  return gatherer.finish();
}

}  // namespace mirrorarm::calibration
