#include "core/calibration/image_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <system_error>

namespace mirrorarm::calibration {
namespace {

using Path = std::filesystem::path;
using Paths = std::vector<Path>;

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool isImage(const Path& file) {
  constexpr std::array<std::string_view, 7> endings = {".png", ".jpg",  ".jpeg", ".bmp",
                                                       ".tif", ".tiff", ".pgm"};
  return std::find(endings.begin(), endings.end(), lowerCase(file.extension().string())) != endings.end();
}

/// `pattern` holds at most one '*'.
bool matches(std::string_view name, std::string_view pattern) {
  const auto star = pattern.find('*');
  if (star == std::string_view::npos) return true;
  const auto head = pattern.substr(0, star), tail = pattern.substr(star + 1);
  return name.size() >= head.size() + tail.size() && name.starts_with(head) && name.ends_with(tail);
}

/// What makes two images partners.
std::string keyOf(const Path& file) {
  const std::string stem = lowerCase(file.stem().string());
  const auto last = stem.find_last_not_of("0123456789");
  std::string number = stem.substr(last == std::string::npos ? 0 : last + 1);
  if (!number.empty()) {
    number.erase(0, std::min(number.find_first_not_of('0'), number.size() - 1));
    return number;
  }
  std::string key = stem;
  for (const std::string side : {"left", "right"})
    if (const auto at = key.find(side); at != std::string::npos) key.erase(at, side.size());
  return key;
}

Paths ofSide(const Paths& files, const std::string& side) {
  Paths chosen;
  std::copy_if(files.begin(), files.end(), std::back_inserter(chosen), [&](const Path& file) {
    return lowerCase(file.stem().string()).find(side) != std::string::npos;
  });
  return chosen;
}

FromFile<std::map<std::string, Path>> byKey(const Paths& files) {
  std::map<std::string, Path> keyed;
  for (const auto& file : files) {
    const auto [entry, is_new] = keyed.emplace(keyOf(file), file);
    if (is_new) continue;
    return unexpected(FileError{file, 0, "has the same number as " + entry->second.filename().string()});
  }
  return keyed;
}

FromFile<std::vector<ImagePair>> paired(const Paths& left, const Paths& right) {
  const auto partners = byKey(right);
  if (!partners) return unexpected(partners.error());
  if (const auto keyed = byKey(left); !keyed) return unexpected(keyed.error());
  std::vector<ImagePair> pairs;
  for (const auto& file : left) {
    const auto partner = partners->find(keyOf(file));
    if (partner == partners->end())
      return unexpected(FileError{file, 0, "has no partner among the right images"});
    pairs.emplace_back(file, partner->second);
  }
  return pairs;
}

bool areOne(const Path& a, const Path& b) {
  std::error_code failed;
  return std::filesystem::equivalent(a, b, failed) && !failed;
}

}  // namespace

FromFile<Paths> listImages(const Path& images) {
  const bool is_pattern = images.filename().string().find('*') != std::string::npos;
  const Path folder = is_pattern ? images.parent_path() : images;
  std::error_code failed;
  Paths found;
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, failed))
    if (isImage(entry.path()) &&
        (!is_pattern || matches(entry.path().filename().string(), images.filename().string())))
      found.push_back(entry.path());
  if (failed) return unexpected(FileError{folder, 0, "is no folder that can be read"});
  if (found.empty()) return unexpected(FileError{images, 0, "holds no images (png, jpg, bmp, tif, pgm)"});
  std::sort(found.begin(), found.end());
  return found;
}

FromFile<std::vector<ImagePair>> listImagePairs(const Path& left, const Path& right) {
  auto left_files = listImages(left);
  if (!left_files) return unexpected(left_files.error());
  auto right_files = listImages(right);
  if (!right_files) return unexpected(right_files.error());
  if (areOne(left, right)) {
    left_files = ofSide(*left_files, "left");
    right_files = ofSide(*right_files, "right");
  }
  if (left_files->size() != right_files->size())
    return unexpected(FileError{right, 0,
                                "holds " + std::to_string(right_files->size()) + " images where " +
                                    left.string() + " holds " + std::to_string(left_files->size())});
  return paired(*left_files, *right_files);
}

}  // namespace mirrorarm::calibration
