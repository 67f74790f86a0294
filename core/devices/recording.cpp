#include "core/devices/recording.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/camera/image_file.h"
#include "core/camera/rig_file.h"
#include "core/common/csv.h"

namespace mirrorarm::devices {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"index", "time_ns", "exposure_us", "left", "right"};

/// A recording is self-contained: a path that leads out of its folder is a mistake or worse.
bool staysInside(const std::filesystem::path& path) {
  return !path.empty() && path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

FileError refusal(const CsvTable& table, const CsvRow& row, std::string reason) {
  return {table.file(), row.line, std::move(reason)};
}

FromFile<std::filesystem::path> imagePath(const CsvTable& table, const CsvRow& row, int column) {
  const std::filesystem::path path = row.cells[static_cast<std::size_t>(column)];
  if (staysInside(path)) return path;
  return unexpected(refusal(table, row, "image '" + path.string() + "' is not a path inside the recording"));
}

FromFile<camera::GreyImage> imageOfSize(const std::filesystem::path& file, const camera::Intrinsics& camera) {
  auto image = camera::readImage(file);
  if (!image || (image->width() == camera.width_px && image->height() == camera.height_px)) return image;
  return unexpected(FileError{file, 0,
                              "is " + std::to_string(image->width()) + "x" + std::to_string(image->height()) +
                                  " where the rig has " + std::to_string(camera.width_px) + "x" +
                                  std::to_string(camera.height_px)});
}

}  // namespace

struct Recording::Reader {
  static FromFile<Entry> entry(const CsvTable& table, const CsvRow& row, const std::vector<int>& columns) {
    const auto index = table.integer(row, columns[0]);
    if (!index) return unexpected(index.error());
    const auto time_ns = table.integer(row, columns[1]);
    if (!time_ns) return unexpected(time_ns.error());
    const auto exposure_us = table.number(row, columns[2]);
    if (!exposure_us) return unexpected(exposure_us.error());
    auto left = imagePath(table, row, columns[3]);
    if (!left) return unexpected(left.error());
    auto right = imagePath(table, row, columns[4]);
    if (!right) return unexpected(right.error());
    if (*index < 0) return unexpected(refusal(table, row, "index is negative"));
    if (*exposure_us < 0.0) return unexpected(refusal(table, row, "exposure_us is negative"));
    return Entry{*index, *time_ns, *exposure_us, std::move(*left), std::move(*right)};
  }

  static FromFile<std::vector<Entry>> entries(const std::filesystem::path& file) {
    const auto table = CsvTable::read(file);
    if (!table) return unexpected(table.error());
    const auto columns = table->columns(kColumns);
    if (!columns) return unexpected(columns.error());
    std::vector<Entry> entries;
    for (const auto& row : table->rows()) {
      auto next = entry(*table, row, *columns);
      if (!next) return unexpected(next.error());
      if (!entries.empty() &&
          (next->index <= entries.back().index || next->time_ns <= entries.back().time_ns))
        return unexpected(refusal(*table, row, "is not later than the frame before"));
      entries.push_back(std::move(*next));
    }
    if (entries.empty()) return unexpected(FileError{file, 0, "holds no frame"});
    return entries;
  }
};

FromFile<Recording> Recording::open(const std::filesystem::path& folder) {
  Recording recording;
  recording.folder_ = folder;
  auto rig = camera::readRig(folder / "rig.yaml");
  if (!rig) return unexpected(rig.error());
  auto frames = Reader::entries(folder / "frames.csv");
  if (!frames) return unexpected(frames.error());
  recording.rig_ = std::move(*rig);
  recording.frames_ = std::move(*frames);
  return recording;
}

FromFile<camera::StereoFrame> Recording::frame(std::size_t i) const {
  const Entry& entry = frames_[i];
  auto left = imageOfSize(folder_ / entry.left, rig_.left.intrinsics());
  if (!left) return unexpected(left.error());
  auto right = imageOfSize(folder_ / entry.right, rig_.right.intrinsics());
  if (!right) return unexpected(right.error());
  return camera::StereoFrame{std::move(*left), std::move(*right), exposedAt(i),
                             Seconds(entry.exposure_us * 1e-6), static_cast<std::uint64_t>(entry.index)};
}

}  // namespace mirrorarm::devices
