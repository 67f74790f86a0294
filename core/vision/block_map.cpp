#include "core/vision/block_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/common/lanes.h"

namespace mirrorarm::vision {
namespace {

constexpr int kTileRows = 8;            // of blocks: 64 pixels
constexpr int kQuantile = 4;            // the fifth darkest of eight: next to the median
constexpr int kAside = 2;               // blocks to the left and right whose median counts
constexpr float kLeastOfEight = 1.42F;  // noises that the darkest of eight pixels lies below their mean

constexpr int kZone_px = 256;
constexpr int kSamplesAcross = 24;
constexpr int kSamplesDown = 16;
constexpr double kStepQuantile = 0.7;
constexpr double kNoisesAStep = 1.466;  // of the step between two pixels, at that quantile

constexpr float kNoisesAbove = 5.0F;
constexpr float kLeastContrast = 10.0F;
constexpr float kLeastNoise = 0.5F;

/// Where one row of blocks lies in the image, and where its answers go.
struct BlockRow {
  const camera::ImageView& image;
  int left;
  int top;
  int width;
  int height;
  std::uint8_t* brightest;
  std::uint8_t* low;
};

/// Asks for the same place in the next row of blocks: eight short rows at a time are no pattern that a
/// processor foresees by itself.
MIRRORARM_INLINE void fetchBelow(const BlockRow& row, int x) {
  constexpr int kLine_bytes = 64;
  if (x % kLine_bytes != 0) return;
  const int end = std::min(row.top + 2 * BlockMap::kHeight_px, row.image.height_px);
  for (int y = row.top + BlockMap::kHeight_px; y < end; ++y)
    __builtin_prefetch(row.image.row(y) + row.left + x);
}

/// Two blocks of full width from the pixel column `x` of the row on; `first` of them is written and what
/// follows.
template <int kFlip>
MIRRORARM_INLINE void readPair(const BlockRow& row, int x, int first) {
  lanes::Bytes high{}, low = lanes::Bytes{} - 1;
  for (int y = 0; y < row.height; ++y) {
    lanes::Bytes pixels;
    std::memcpy(&pixels, row.image.row(row.top + y) + row.left + x, sizeof pixels);
    pixels ^= static_cast<std::uint8_t>(kFlip);
    high = pixels > high ? pixels : high;
    low = pixels < low ? pixels : low;
  }
  const lanes::Longs largest = lanes::largestOfEights(high);
  const lanes::Longs sums = lanes::sumsOfEights(low);
  for (int i = first; i < 2; ++i) {
    const int column = x / BlockMap::kWidth_px + i;
    row.brightest[column] = static_cast<std::uint8_t>(std::max(largest[2 * i], largest[2 * i + 1]));
    row.low[column] = static_cast<std::uint8_t>((sums[2 * i] + sums[2 * i + 1]) / BlockMap::kWidth_px);
  }
}

/// One block, of any width.
template <int kFlip>
MIRRORARM_INLINE void readOne(const BlockRow& row, int column) {
  const int first = column * BlockMap::kWidth_px;
  const int end = std::min(first + BlockMap::kWidth_px, row.width);
  std::uint8_t high = 0;
  int sum = 0;
  for (int x = first; x < end; ++x) {
    std::uint8_t low = 255;
    for (int y = 0; y < row.height; ++y) {
      const auto pixel = static_cast<std::uint8_t>(row.image.at(row.left + x, row.top + y) ^ kFlip);
      high = std::max(high, pixel);
      low = std::min(low, pixel);
    }
    sum += low;
  }
  row.brightest[column] = high;
  row.low[column] = static_cast<std::uint8_t>(sum / (end - first));
}

template <int kFlip>
MIRRORARM_INLINE void readBlocks(const BlockRow& row) {
  constexpr int kPair_px = 2 * BlockMap::kWidth_px;
  static_assert(sizeof(lanes::Bytes) == kPair_px);
  int x = 0;
  for (; x + kPair_px <= row.width; x += kPair_px) {
    fetchBelow(row, x);
    readPair<kFlip>(row, x, 0);
  }
  if (x > 0 && row.width - x == BlockMap::kWidth_px)
    readPair<kFlip>(row, x - BlockMap::kWidth_px, 1);
  else
    for (; x < row.width; x += BlockMap::kWidth_px) readOne<kFlip>(row, x / BlockMap::kWidth_px);
}

MIRRORARM_VECTOR_CODE void readBright(const BlockRow& row) { readBlocks<0>(row); }
MIRRORARM_VECTOR_CODE void readDark(const BlockRow& row) { readBlocks<255>(row); }

MIRRORARM_INLINE std::uint8_t medianOfThree(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// Puts the smaller of two rows first, column by column.
MIRRORARM_VECTOR_CODE void order(std::uint8_t* a, std::uint8_t* b, int columns) {
  for (int i = 0; i < columns; ++i) {
    const std::uint8_t low = std::min(a[i], b[i]);
    b[i] = std::max(a[i], b[i]);
    a[i] = low;
  }
}

/// Median of five neighbours; `from` holds two columns more on each side than `to`.
MIRRORARM_VECTOR_CODE void medianAlong(const std::uint8_t* from, int columns, std::uint8_t* to) {
  for (int i = 0; i < columns; ++i) {
    const std::uint8_t a = from[i], b = from[i + 1], c = from[i + 3], d = from[i + 4];
    const std::uint8_t low = std::max(std::min(a, b), std::min(c, d));
    const std::uint8_t high = std::min(std::max(a, b), std::max(c, d));
    to[i] = medianOfThree(low, from[i + 2], high);
  }
}

MIRRORARM_VECTOR_CODE void medianAcross(const std::uint8_t* above, const std::uint8_t* here,
                                        const std::uint8_t* below, int columns, std::uint8_t* to) {
  for (int i = 0; i < columns; ++i) to[i] = medianOfThree(above[i], here[i], below[i]);
}

/// Ground between two rows of tiles, and the threshold over it.
MIRRORARM_VECTOR_CODE void setRow(const std::uint8_t* above, const std::uint8_t* below, float share,
                                  int columns, const float* noise, float* ground, std::uint8_t* threshold) {
  for (int i = 0; i < columns; ++i) {
    const float low = static_cast<float>(above[i]);
    ground[i] = low + share * (static_cast<float>(below[i]) - low) + kLeastOfEight * noise[i];
    const float wanted = ground[i] + std::max(kLeastContrast, kNoisesAbove * noise[i]);
    threshold[i] = static_cast<std::uint8_t>(static_cast<int>(std::min(wanted, 255.0F)));
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
  for (int row = 0; row < rows_; ++row) readRow(image, row);
  measureNoise(image);
  findGround();
}

void BlockMap::readRow(const Brightness& image, int row) {
  const int top = region_.top + row * kHeight_px;
  const BlockRow blocks{image.image,
                        region_.left,
                        top,
                        region_.width(),
                        std::min(kHeight_px, region_.bottom + 1 - top),
                        &brightest_[at(0, row)],
                        &low_[at(0, row)]};
  if (image.flip == 0)
    readBright(blocks);
  else
    readDark(blocks);
}

/// Quantile over eight blocks one above the other, then the median of its neighbours in the row.
void BlockMap::takeQuantile(int tile) {
  const int first = std::max(std::min(tile * kTileRows, rows_ - kTileRows), 0);
  for (int i = 0; i < kTileRows; ++i)
    std::copy_n(&low_[at(0, std::min(first + i, rows_ - 1))], columns_, &sorted_[at(0, i)]);
  // A selection sort, of which the first passes are enough.
  for (int i = 0; i <= kQuantile; ++i)
    for (int j = i + 1; j < kTileRows; ++j) order(&sorted_[at(0, i)], &sorted_[at(0, j)], columns_);
  const std::uint8_t* quantile = &sorted_[at(0, kQuantile)];
  std::copy_n(quantile, columns_, &padded_[kAside]);
  std::fill_n(padded_.begin(), kAside, quantile[0]);
  std::fill_n(padded_.begin() + kAside + columns_, kAside, quantile[columns_ - 1]);
  medianAlong(padded_.data(), columns_, &along_[at(0, tile)]);
}

/// The quantile of each tile, then the median of its neighbours in the row and of the tiles above and below;
/// between the middles of tiles it is interpolated.
void BlockMap::findGround() {
  const int tiles = (rows_ + kTileRows - 1) / kTileRows;
  sorted_.resize(at(0, kTileRows));
  padded_.resize(static_cast<std::size_t>(columns_ + 2 * kAside));
  along_.resize(at(0, tiles));
  tile_ground_.resize(at(0, tiles));
  for (int tile = 0; tile < tiles; ++tile) takeQuantile(tile);
  for (int tile = 0; tile < tiles; ++tile)
    medianAcross(&along_[at(0, std::max(tile - 1, 0))], &along_[at(0, tile)],
                 &along_[at(0, std::min(tile + 1, tiles - 1))], columns_, &tile_ground_[at(0, tile)]);
  block_noise_.resize(static_cast<std::size_t>(columns_));
  for (int row = 0; row < rows_; ++row) {
    if (row % (kZone_px / kHeight_px) == 0)
      for (int column = 0; column < columns_; ++column)
        block_noise_[static_cast<std::size_t>(column)] =
            zone_noise_[zoneAt(region_.left + column * kWidth_px, region_.top + row * kHeight_px)];
    const float along = (static_cast<float>(row) + 0.5F) / kTileRows - 0.5F;
    const int tile = std::clamp(static_cast<int>(std::floor(along)), 0, tiles - 1);
    const float share = std::clamp(along - static_cast<float>(tile), 0.0F, 1.0F);
    setRow(&tile_ground_[at(0, tile)], &tile_ground_[at(0, std::min(tile + 1, tiles - 1))], share, columns_,
           block_noise_.data(), &ground_[at(0, row)], &threshold_[at(0, row)]);
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
