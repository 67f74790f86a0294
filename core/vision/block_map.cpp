#include "core/vision/block_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/common/lanes.h"

namespace mirrorarm::vision {
namespace {

constexpr int kTileRows = 8;            // of blocks: 64 pixels
constexpr std::size_t kQuantile = 2;    // third darkest of eight
constexpr int kAside = 2;               // blocks to the left and right whose median counts
constexpr double kLeastOfEight = 1.42;  // noises that the darkest of eight pixels lies below their mean

constexpr int kZone_px = 256;
constexpr int kSamplesAcross = 24;
constexpr int kSamplesDown = 16;
constexpr double kStepQuantile = 0.7;
constexpr double kNoisesAStep = 1.466;  // of the step between two pixels, at that quantile

constexpr float kNoisesAbove = 5.0F;
constexpr float kLeastContrast = 10.0F;
constexpr float kLeastNoise = 0.5F;

/// Brightest and darkest of up to eight rows, pixel column by pixel column.
template <int kFlip>
MIRRORARM_INLINE void extremes(const camera::ImageView& image, int left, int top, int width, int height,
                               std::uint8_t* most, std::uint8_t* least) {
  int x = 0;
  for (constexpr int kStep = sizeof(lanes::Bytes); x + kStep <= width; x += kStep) {
    lanes::Bytes high{}, low = lanes::Bytes{} - 1;
    for (int y = 0; y < height; ++y) {
      lanes::Bytes pixels;
      std::memcpy(&pixels, image.row(top + y) + left + x, sizeof pixels);
      pixels ^= static_cast<std::uint8_t>(kFlip);
      high = pixels > high ? pixels : high;
      low = pixels < low ? pixels : low;
    }
    std::memcpy(most + x, &high, sizeof high);
    std::memcpy(least + x, &low, sizeof low);
  }
  for (; x < width; ++x) {
    most[x] = 0;
    least[x] = 255;
    for (int y = 0; y < height; ++y) {
      const auto pixel = static_cast<std::uint8_t>(image.at(left + x, top + y) ^ kFlip);
      most[x] = std::max(most[x], pixel);
      least[x] = std::min(least[x], pixel);
    }
  }
}

MIRRORARM_VECTOR_CODE void extremesOfBright(const camera::ImageView& image, int left, int top, int width,
                                            int height, std::uint8_t* most, std::uint8_t* least) {
  extremes<0>(image, left, top, width, height, most, least);
}

MIRRORARM_VECTOR_CODE void extremesOfDark(const camera::ImageView& image, int left, int top, int width,
                                          int height, std::uint8_t* most, std::uint8_t* least) {
  extremes<255>(image, left, top, width, height, most, least);
}

/// Brightest pixel and mean of the dark ones over each block of one row.
MIRRORARM_VECTOR_CODE void gather(const std::uint8_t* most, const std::uint8_t* least, int width, int columns,
                                  std::uint8_t* brightest, std::uint8_t* low) {
  for (int column = 0; column < columns; ++column) {
    const int first = column * BlockMap::kWidth_px;
    const int count = std::min(BlockMap::kWidth_px, width - first);
    std::uint8_t high = 0;
    unsigned sum = 0;
    if (count == BlockMap::kWidth_px) {
      for (int i = 0; i < BlockMap::kWidth_px; ++i) high = std::max(high, most[first + i]);
      for (int i = 0; i < BlockMap::kWidth_px; ++i) sum += least[first + i];
    } else {
      for (int i = 0; i < count; ++i) high = std::max(high, most[first + i]);
      for (int i = 0; i < count; ++i) sum += least[first + i];
    }
    brightest[column] = high;
    low[column] = static_cast<std::uint8_t>(sum / static_cast<unsigned>(count));
  }
}

template <std::size_t kCount>
std::uint8_t nthOf(std::array<std::uint8_t, kCount> values, std::size_t nth) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(nth), values.end());
  return values[nth];
}

/// Puts the smaller of two rows first, column by column.
MIRRORARM_VECTOR_CODE void order(std::uint8_t* a, std::uint8_t* b, int columns) {
  for (int i = 0; i < columns; ++i) {
    const std::uint8_t low = std::min(a[i], b[i]);
    b[i] = std::max(a[i], b[i]);
    a[i] = low;
  }
}

float medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void BlockMap::read(const Brightness& image, const Region& region) {
  region_ = region;
  columns_ = (region.width() + kWidth_px - 1) / kWidth_px;
  rows_ = (region.height() + kHeight_px - 1) / kHeight_px;
  const auto blocks = at(0, rows_);
  brightest_.resize(blocks);
  low_.resize(blocks);
  ground_.resize(blocks);
  threshold_.resize(blocks);
  column_most_.resize(static_cast<std::size_t>(region.width()));
  column_least_.resize(column_most_.size());
  for (int row = 0; row < rows_; ++row) readRow(image, row);
  measureNoise(image);
  findGround();
  setThresholds();
}

void BlockMap::readRow(const Brightness& image, int row) {
  const int top = region_.top + row * kHeight_px;
  const int height = std::min(kHeight_px, region_.bottom + 1 - top);
  const int width = region_.width();
  if (image.flip == 0)
    extremesOfBright(image.image, region_.left, top, width, height, column_most_.data(),
                     column_least_.data());
  else
    extremesOfDark(image.image, region_.left, top, width, height, column_most_.data(), column_least_.data());
  gather(column_most_.data(), column_least_.data(), width, columns_, &brightest_[at(0, row)],
         &low_[at(0, row)]);
}

/// Low quantile over eight blocks one above the other, then the median of neighbours in the row and of tiles
/// above and below; between the middles of tiles it is interpolated.
void BlockMap::findGround() {
  const int tiles = (rows_ + kTileRows - 1) / kTileRows;
  tile_low_.resize(at(0, tiles));
  smooth_low_.resize(at(0, kTileRows));
  for (int tile = 0; tile < tiles; ++tile) {
    const int first = std::max(std::min(tile * kTileRows, rows_ - kTileRows), 0);
    for (int i = 0; i < kTileRows; ++i)
      std::copy_n(&low_[at(0, std::min(first + i, rows_ - 1))], columns_, &smooth_low_[at(0, i)]);
    // Three passes of a selection sort bring the three darkest to the front.
    for (std::size_t i = 0; i <= kQuantile; ++i)
      for (int j = static_cast<int>(i) + 1; j < kTileRows; ++j)
        order(&smooth_low_[at(0, static_cast<int>(i))], &smooth_low_[at(0, j)], columns_);
    std::copy_n(&smooth_low_[at(0, static_cast<int>(kQuantile))], columns_, &tile_low_[at(0, tile)]);
  }
  smooth_low_.resize(at(0, tiles));
  for (int tile = 0; tile < tiles; ++tile)
    for (int column = 0; column < columns_; ++column) {
      std::array<std::uint8_t, 2 * kAside + 1> around{};
      for (int i = -kAside; i <= kAside; ++i)
        around[static_cast<std::size_t>(i + kAside)] =
            tile_low_[at(std::clamp(column + i, 0, columns_ - 1), tile)];
      smooth_low_[at(column, tile)] = nthOf(around, kAside);
    }
  for (int tile = 0; tile < tiles; ++tile)
    for (int column = 0; column < columns_; ++column)
      tile_low_[at(column, tile)] =
          nthOf<3>({smooth_low_[at(column, std::max(tile - 1, 0))], smooth_low_[at(column, tile)],
                    smooth_low_[at(column, std::min(tile + 1, tiles - 1))]},
                   1);
  for (int row = 0; row < rows_; ++row) {
    const float along = (static_cast<float>(row) + 0.5F) / kTileRows - 0.5F;
    const int tile = std::clamp(static_cast<int>(std::floor(along)), 0, tiles - 1);
    const int next = std::min(tile + 1, tiles - 1);
    const float share = std::clamp(along - static_cast<float>(tile), 0.0F, 1.0F);
    for (int column = 0; column < columns_; ++column)
      ground_[at(column, row)] = std::lerp(static_cast<float>(tile_low_[at(column, tile)]),
                                           static_cast<float>(tile_low_[at(column, next)]), share);
  }
}

/// Steps between neighbouring pixels: few of them lie on an edge.
void BlockMap::measureNoise(const Brightness& image) {
  zone_columns_ = (region_.width() + kZone_px - 1) / kZone_px;
  zone_rows_ = (region_.height() + kZone_px - 1) / kZone_px;
  zone_noise_.resize(static_cast<std::size_t>(zone_columns_ * zone_rows_));
  for (int zone = 0; zone < zone_columns_ * zone_rows_; ++zone) {
    const int left = region_.left + zone % zone_columns_ * kZone_px;
    const int top = region_.top + zone / zone_columns_ * kZone_px;
    const int width = std::min(kZone_px, region_.right - left);  // a step needs its right neighbour
    const int height = std::min(kZone_px, region_.bottom + 1 - top);
    std::array<std::uint16_t, 256> counts{};
    int total = 0;
    for (int i = 0; i < kSamplesDown; ++i) {
      const std::uint8_t* pixels = image.image.row(top + i * height / kSamplesDown) + left;
      for (int j = 0; width > 0 && j < kSamplesAcross; ++j, ++total) {
        const int x = j * width / kSamplesAcross;
        ++counts[static_cast<std::size_t>(std::abs(pixels[x + 1] - pixels[x]))];
      }
    }
    const double wanted = kStepQuantile * total;
    int below = 0;
    std::size_t step = 0;
    while (step < 255 && below + counts[step] <= static_cast<int>(wanted)) below += counts[step++];
    // A step of k stands for all that round to it, from k - 1/2 to k + 1/2; none are below 0.
    const double level =
        std::max(static_cast<double>(step) - 0.5 + (wanted - below) / std::max<int>(counts[step], 1), 0.0);
    zone_noise_[static_cast<std::size_t>(zone)] =
        std::max(kLeastNoise, static_cast<float>(level / kNoisesAStep));
  }
}

void BlockMap::setThresholds() {
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const float noise =
          zone_noise_[zoneAt(region_.left + column * kWidth_px, region_.top + row * kHeight_px)];
      float& ground = ground_[at(column, row)];
      ground += static_cast<float>(kLeastOfEight) * noise;
      const float wanted = ground + std::max(kLeastContrast, kNoisesAbove * noise);
      threshold_[at(column, row)] = static_cast<std::uint8_t>(std::clamp(wanted, 0.0F, 255.0F));
    }
}

std::size_t BlockMap::blockAt(double x, double y) const {
  return at(std::clamp((static_cast<int>(x) - region_.left) / kWidth_px, 0, columns_ - 1),
            std::clamp((static_cast<int>(y) - region_.top) / kHeight_px, 0, rows_ - 1));
}

std::size_t BlockMap::zoneAt(double x, double y) const {
  const int column = std::clamp((static_cast<int>(x) - region_.left) / kZone_px, 0, zone_columns_ - 1);
  const int row = std::clamp((static_cast<int>(y) - region_.top) / kZone_px, 0, zone_rows_ - 1);
  return static_cast<std::size_t>(row * zone_columns_ + column);
}

float BlockMap::ground() {
  // Every seventh block is enough for a median.
  scratch_.clear();
  for (std::size_t i = 0; i < ground_.size(); i += 7) scratch_.push_back(ground_[i]);
  return medianOf(scratch_);
}

float BlockMap::noise() {
  scratch_.assign(zone_noise_.begin(), zone_noise_.end());
  return medianOf(scratch_);
}

}  // namespace mirrorarm::vision
