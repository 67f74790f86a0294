#include "core/vision/threshold_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorarm::vision {
namespace {

// Quantiles on the dark side: what is bright in a tile does not reach them until it covers two thirds.
constexpr double kBackgroundQuantile = 0.35;
constexpr double kLowQuantile = 0.05;
constexpr double kSigmasBetween = 1.26;  // of a normal distribution, between the two quantiles
constexpr double kSigmasToMedian = 0.385;
// Steps between neighbours: few of them lie on an edge, and they show noise also where the dark side is
// clipped.
constexpr double kStepQuantile = 0.7;
constexpr double kSigmasAStep = 1.466;

constexpr float kNoisesAbove = 5.0F;
constexpr float kLeastContrast = 10.0F;
constexpr float kLeastNoise = 0.5F;

/// Histogram of one tile.
class Levels {
 public:
  void add(std::uint8_t value) {
    ++counts_[value];
    ++total_;
  }
  [[nodiscard]] bool empty() const { return total_ == 0; }
  /// Level below which the share `quantile` lies, linear inside the level.
  [[nodiscard]] double level(double quantile) const {
    const double wanted = quantile * total_;
    const int whole = static_cast<int>(wanted);
    int below = 0;
    std::size_t value = 0;
    while (value < 255 && below + counts_[value] <= whole) below += counts_[value++];
    return static_cast<double>(value) - 0.5 + (wanted - below) / std::max<int>(counts_[value], 1);
  }

 private:
  std::array<std::uint16_t, 256> counts_{};
  int total_ = 0;
};

/// Median of the 3x3 neighbourhood in a map of columns x rows, fewer at its border.
float medianAround(const std::vector<float>& map, int columns, int rows, int column, int row) {
  std::array<float, 9> values{};
  std::size_t count = 0;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y)
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns - 1); ++x)
      values[count++] = map[static_cast<std::size_t>(y * columns + x)];
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

void smooth(std::vector<float>& map, std::vector<float>& scratch, int columns, int rows) {
  scratch.resize(map.size());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      scratch[static_cast<std::size_t>(row * columns + column)] =
          medianAround(map, columns, rows, column, row);
  map.swap(scratch);
}

/// Tile and share of the next one, for a coordinate counted from the region's beginning.
struct Between {
  int tile;
  int next;
  float share;
};

Between between(int offset_px, int tiles) {
  const float at = (static_cast<float>(offset_px) + 0.5F) / ThresholdMap::kTile_px - 0.5F;
  const int tile = std::clamp(static_cast<int>(std::floor(at)), 0, tiles - 1);
  return {tile, std::min(tile + 1, tiles - 1), std::clamp(at - static_cast<float>(tile), 0.0F, 1.0F)};
}

}  // namespace

void ThresholdMap::estimate(const Brightness& image, const Region& region) {
  region_ = region;
  columns_ = (region.width() + kTile_px - 1) / kTile_px;
  rows_ = (region.height() + kTile_px - 1) / kTile_px;
  background_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  noise_.resize(background_.size());
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) measureTile(image, column, row);
  smooth(background_, scratch_, columns_, rows_);
  smooth(noise_, scratch_, columns_, rows_);
  threshold_.resize(background_.size());
  for (std::size_t tile = 0; tile < threshold_.size(); ++tile)
    threshold_[tile] = background_[tile] + std::max(kLeastContrast, kNoisesAbove * noise_[tile]);
}

void ThresholdMap::measureTile(const Brightness& image, int column, int row) {
  // The last tiles are moved back inside, so that every tile is full where the region is large enough.
  const int left =
      std::max(region_.left, std::min(region_.left + column * kTile_px, region_.right + 1 - kTile_px));
  const int top =
      std::max(region_.top, std::min(region_.top + row * kTile_px, region_.bottom + 1 - kTile_px));
  const int right = std::min(left + kTile_px - 1, region_.right);
  const int bottom = std::min(top + kTile_px - 1, region_.bottom);
  const bool large = region_.width() * region_.height() > 64 * kTile_px * kTile_px;
  const int step = large ? 4 : 1;
  Levels levels;
  Levels steps;
  for (int y = top; y <= bottom; y += step) {
    const std::uint8_t* row_pixels = image.image.row(y);
    for (int x = left; x < right; x += step) {
      const int value = row_pixels[x];
      levels.add(static_cast<std::uint8_t>(value ^ image.flip));
      steps.add(static_cast<std::uint8_t>(std::abs(row_pixels[x + 1] - value)));
    }
  }
  if (levels.empty()) levels.add(image.at(left, top));
  const double at_background = levels.level(kBackgroundQuantile);
  const double sigma = std::max((at_background - levels.level(kLowQuantile)) / kSigmasBetween,
                                steps.level(kStepQuantile) / kSigmasAStep);
  const auto tile = static_cast<std::size_t>(row * columns_ + column);
  noise_[tile] = std::max(kLeastNoise, static_cast<float>(sigma));
  background_[tile] = static_cast<float>(at_background + kSigmasToMedian * sigma);
}

void ThresholdMap::thresholds(int y, std::span<std::uint8_t> row) const {
  const auto vertical = between(y - region_.top, rows_);
  const float* above = threshold_.data() + vertical.tile * columns_;
  const float* below = threshold_.data() + vertical.next * columns_;
  const auto at = [&](int column) {
    return above[column] + vertical.share * (below[column] - above[column]);
  };
  const auto clipped = [](float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F)); };
  const int width = static_cast<int>(row.size());
  for (int column = -1, x = 0; x < width; ++column) {
    const float begin = at(std::max(column, 0));
    const float slope = (at(std::min(column + 1, columns_ - 1)) - begin) / kTile_px;
    const int centre = column * kTile_px + kTile_px / 2;
    for (const int end = std::min(centre + kTile_px, width); x < end; ++x)
      row[static_cast<std::size_t>(x)] = clipped(begin + slope * static_cast<float>(x - centre));
  }
}

float ThresholdMap::nearest(const std::vector<float>& map, double x, double y) const {
  const int column = std::clamp((static_cast<int>(x) - region_.left) / kTile_px, 0, columns_ - 1);
  const int row = std::clamp((static_cast<int>(y) - region_.top) / kTile_px, 0, rows_ - 1);
  return map[static_cast<std::size_t>(row * columns_ + column)];
}

}  // namespace mirrorarm::vision
