#include "core/vision/component_scanner.h"

#include <algorithm>

namespace mirrorarm::vision {
namespace {

constexpr int kRowsAThreshold = 8;
constexpr int kBlock_px = 64;

/// True when a pixel of the block is above its threshold. Without branches, so that it becomes vector code:
/// nearly all of an image goes through here and no further.
template <int kFlip>
bool anyAboveIn(const std::uint8_t* pixels, const std::uint8_t* thresholds) {
  std::uint8_t any = 0;
  for (int i = 0; i < kBlock_px; ++i) {
    const auto value = static_cast<std::uint8_t>(pixels[i] ^ kFlip);
    any |= static_cast<std::uint8_t>(value - std::min(value, thresholds[i]));
  }
  return any != 0;
}

bool anyAbove(const std::uint8_t* pixels, const std::uint8_t* thresholds, std::uint8_t flip) {
  return flip == 0 ? anyAboveIn<0>(pixels, thresholds) : anyAboveIn<255>(pixels, thresholds);
}

void merge(Component& into, const Component& from) {
  into.box = hull(into.box, from.box);
  into.area_px += from.area_px;
  into.sum_x += from.sum_x;
  into.sum_y += from.sum_y;
  into.peak = std::max(into.peak, from.peak);
  into.clipped_px += from.clipped_px;
}

}  // namespace

std::span<const Component> ComponentScanner::scan(const Brightness& image, const Region& region,
                                                  const ThresholdMap& map) {
  begin(region);
  for (int y = region.top; y <= region.bottom; ++y) {
    if ((y - region.top) % kRowsAThreshold == 0)
      map.thresholds(std::min(y + kRowsAThreshold / 2, region.bottom), thresholds_);
    scanRow(image, y);
  }
  return finish();
}

std::span<const Component> ComponentScanner::scan(const Brightness& image, const Region& region,
                                                  std::uint8_t threshold) {
  begin(region);
  std::fill(thresholds_.begin(), thresholds_.end(), threshold);
  for (int y = region.top; y <= region.bottom; ++y) scanRow(image, y);
  return finish();
}

void ComponentScanner::begin(const Region& region) {
  region_ = region;
  thresholds_.resize(static_cast<std::size_t>(region.width()));
  above_.clear();
  components_.clear();
  parents_.clear();
}

void ComponentScanner::scanRow(const Brightness& image, int y) {
  current_.clear();
  oldest_ = 0;
  const std::uint8_t* pixels = image.image.row(y) + region_.left;
  const int width = region_.width();
  int first = -1;
  for (int block = 0; block < width; block += kBlock_px) {
    const bool full = block + kBlock_px <= width;
    if (full && first < 0 && !anyAbove(pixels + block, thresholds_.data() + block, image.flip)) continue;
    for (int x = block, end = std::min(block + kBlock_px, width); x < end; ++x) {
      const bool bright = (pixels[x] ^ image.flip) > thresholds_[static_cast<std::size_t>(x)];
      if (bright && first < 0) first = x;
      if (!bright && first >= 0) {
        addRun(image, y, region_.left + first, region_.left + x - 1);
        first = -1;
      }
    }
  }
  if (first >= 0) addRun(image, y, region_.left + first, region_.right);
  above_.swap(current_);
}

void ComponentScanner::addRun(const Brightness& image, int y, int first, int last) {
  const int length = last - first + 1;
  Component piece{
      {first, y, last, y}, length, std::int64_t{first + last} * length / 2, std::int64_t{y} * length};
  for (int x = first; x <= last; ++x) {
    const auto value = image.at(x, y);
    piece.peak = std::max(piece.peak, value);
    piece.clipped_px += value == 255 ? 1 : 0;
  }
  const int component = static_cast<int>(components_.size());
  components_.push_back(piece);
  parents_.push_back(component);
  current_.push_back({first, last, component});
  while (oldest_ < above_.size() && above_[oldest_].last < first - 1) ++oldest_;
  for (std::size_t i = oldest_; i < above_.size() && above_[i].first <= last + 1; ++i)
    join(above_[i].component, component);
}

int ComponentScanner::root(int component) {
  auto& parents = parents_;
  while (parents[static_cast<std::size_t>(component)] != component) {
    auto& parent = parents[static_cast<std::size_t>(component)];
    parent = parents[static_cast<std::size_t>(parent)];
    component = parent;
  }
  return component;
}

void ComponentScanner::join(int a, int b) {
  const int low = std::min(root(a), root(b));
  const int high = std::max(root(a), root(b));
  if (low == high) return;
  parents_[static_cast<std::size_t>(high)] = low;
  merge(components_[static_cast<std::size_t>(low)], components_[static_cast<std::size_t>(high)]);
}

std::span<const Component> ComponentScanner::finish() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < components_.size(); ++i)
    if (parents_[i] == static_cast<int>(i)) components_[kept++] = components_[i];
  components_.resize(kept);
  return components_;
}

}  // namespace mirrorarm::vision
