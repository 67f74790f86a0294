#include "core/vision/component_scanner.h"

#include <algorithm>
#include <utility>

namespace mirrorarm::vision {
namespace {

void merge(Component& into, const Component& from) {
  into.box = hull(into.box, from.box);
  into.area_px += from.area_px;
  into.sum_x += from.sum_x;
  into.sum_y += from.sum_y;
  into.sum_xx += from.sum_xx;
  into.sum_xy += from.sum_xy;
  into.sum_yy += from.sum_yy;
  into.peak = std::max(into.peak, from.peak);
  into.clipped_px += from.clipped_px;
}

/// Sum of the squares of 0 .. n.
std::int64_t squaresUpTo(std::int64_t n) { return n * (n + 1) * (2 * n + 1) / 6; }

/// One run of pixels in a row.
Component pieceOf(int y, int first, int last) {
  const std::int64_t length = last - first + 1;
  const std::int64_t sum_x = (std::int64_t{first} + last) * length / 2;
  Component piece;
  piece.box = {first, y, last, y};
  piece.area_px = static_cast<int>(length);
  piece.sum_x = sum_x;
  piece.sum_y = y * length;
  piece.sum_xx = squaresUpTo(last) - squaresUpTo(std::int64_t{first} - 1);
  piece.sum_xy = y * sum_x;
  piece.sum_yy = std::int64_t{y} * y * length;
  return piece;
}

}  // namespace

Eigen::Matrix2d Component::moments_px2() const {
  constexpr double kPixel = 1.0 / 12.0;
  const double n = area_px;
  const double xx = static_cast<double>(sum_xx) / n - x() * x();
  const double xy = static_cast<double>(sum_xy) / n - x() * y();
  const double yy = static_cast<double>(sum_yy) / n - y() * y();
  return (Eigen::Matrix2d() << xx + kPixel, xy, xy, yy + kPixel).finished();
}

std::span<const Component> ComponentScanner::scan(const Brightness& image, const BlockMap& map) {
  begin();
  const Region& region = map.region();
  for (int row = 0; row < map.rows(); ++row) {
    blocks_.clear();
    for (int column = 0; column < map.columns(); ++column)
      if (map.standsOut(column, row)) blocks_.push_back(column);
    const int top = region.top + row * BlockMap::kHeight_px;
    const int bottom = std::min(top + BlockMap::kHeight_px - 1, region.bottom);
    if (blocks_.empty())
      above_.clear();
    else
      for (int y = top; y <= bottom; ++y) scanRow(image, map, row, y);
  }
  return finish();
}

std::span<const Component> ComponentScanner::scan(const Brightness& image, const Region& region,
                                                  std::uint8_t threshold) {
  begin();
  for (int y = region.top; y <= region.bottom; ++y) {
    scanPixels(image, y, region.left, region.right + 1, threshold);
    if (run_begin_ >= 0) closeRun(image, y, region.right);
    endRow();
  }
  return finish();
}

void ComponentScanner::begin() {
  above_.clear();
  current_.clear();
  oldest_ = 0;
  run_begin_ = -1;
  components_.clear();
  parents_.clear();
}

void ComponentScanner::scanRow(const Brightness& image, const BlockMap& map, int row, int y) {
  const Region& region = map.region();
  int reached = region.left;
  for (const int column : blocks_) {
    const int first = region.left + column * BlockMap::kWidth_px;
    if (run_begin_ >= 0 && first != reached) closeRun(image, y, reached - 1);
    reached = std::min(first + BlockMap::kWidth_px, region.right + 1);
    scanPixels(image, y, first, reached, map.threshold(column, row));
  }
  if (run_begin_ >= 0) closeRun(image, y, reached - 1);
  endRow();
}

void ComponentScanner::scanPixels(const Brightness& image, int y, int first, int end,
                                  std::uint8_t threshold) {
  const std::uint8_t* pixels = image.image.row(y);
  for (int x = first; x < end; ++x) {
    const bool bright = (pixels[x] ^ image.flip) > threshold;
    if (bright == (run_begin_ >= 0)) continue;
    if (bright) {
      run_begin_ = x;
      threshold_ = threshold;
    } else {
      closeRun(image, y, x - 1);
    }
  }
}

void ComponentScanner::endRow() {
  above_.swap(current_);
  current_.clear();
  oldest_ = 0;
}

void ComponentScanner::closeRun(const Brightness& image, int y, int last) {
  const int first = std::exchange(run_begin_, -1);
  Component piece = pieceOf(y, first, last);
  piece.threshold = threshold_;
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
