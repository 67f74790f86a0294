#pragma once

#include <cstdint>
#include <vector>

#include "core/vision/brightness.h"

namespace mirrorarm::vision {

/// An image in blocks of 16 x 8 pixels: how bright each block is at most, and how bright a pixel in it must
/// be to stand out. Learnt in the one pass that reads the whole image, at the speed of memory; what follows
/// looks only at blocks that hold something bright. The ground under a block is a median over its
/// surroundings, so that discs do not lift it; the noise is measured from steps between neighbouring pixels.
/// Keeps its buffers.
class BlockMap {
 public:
  static constexpr int kWidth_px = 16;
  static constexpr int kHeight_px = 8;

  /// Reads `region`, which lies inside the image and is not empty. Blocks are counted from its corner; those
  /// at its right and lower end may be smaller.
  void read(const Brightness& image, const Region& region);

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] bool standsOut(int column, int row) const {
    return brightest_[at(column, row)] > threshold_[at(column, row)];
  }
  /// A pixel of the block stands out when it is brighter; 255 lets nothing through.
  [[nodiscard]] std::uint8_t threshold(int column, int row) const { return threshold_[at(column, row)]; }

  /// Ground and noise (standard deviation, at least half a grey value) around a pixel of the region.
  [[nodiscard]] float ground(double x, double y) const { return ground_[blockAt(x, y)]; }
  [[nodiscard]] float noise(double x, double y) const { return zone_noise_[zoneAt(x, y)]; }

  /// Medians over the region.
  [[nodiscard]] float ground();
  [[nodiscard]] float noise();

 private:
  [[nodiscard]] std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::size_t blockAt(double x, double y) const;
  [[nodiscard]] std::size_t zoneAt(double x, double y) const;
  void readRow(const Brightness& image, int row);
  void measureNoise(const Brightness& image);
  void takeQuantile(int tile);
  void findGround();

  Region region_;
  int columns_ = 0;
  int rows_ = 0;
  int zone_columns_ = 0;
  int zone_rows_ = 0;
  std::vector<std::uint8_t> brightest_;
  std::vector<std::uint8_t> low_;     ///< mean over a block of the darkest of each pixel column
  std::vector<std::uint8_t> sorted_;  ///< the rows of blocks of a tile, the darkest first
  std::vector<std::uint8_t> padded_;
  std::vector<std::uint8_t> along_;        ///< per tile, smoothed along its row
  std::vector<std::uint8_t> tile_ground_;  ///< and across
  std::vector<float> block_noise_;         ///< of one row of blocks
  std::vector<float> ground_;
  std::vector<std::uint8_t> threshold_;
  std::vector<float> zone_noise_;
  std::vector<float> scratch_;
};

}  // namespace mirrorarm::vision
