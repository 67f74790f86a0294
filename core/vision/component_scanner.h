#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/vision/block_map.h"
#include "core/vision/brightness.h"

namespace mirrorarm::vision {

/// Bright pixels that hang together, diagonals included.
struct Component {
  Region box;
  int area_px = 0;
  std::int64_t sum_x = 0;
  std::int64_t sum_y = 0;
  std::int64_t sum_xx = 0;
  std::int64_t sum_xy = 0;
  std::int64_t sum_yy = 0;
  std::uint8_t peak = 0;
  std::uint8_t threshold = 0;  ///< that its first pixel has passed
  int clipped_px = 0;          ///< pixels at 255

  [[nodiscard]] double x() const { return static_cast<double>(sum_x) / area_px; }
  [[nodiscard]] double y() const { return static_cast<double>(sum_y) / area_px; }
  /// Second central moments of its pixels, their own area included [px^2].
  [[nodiscard]] Eigen::Matrix2d moments_px2() const;
};

/// Finds connected bright components in one pass over run lengths. Keeps its buffers.
class ComponentScanner {
 public:
  /// Components brighter than the map's thresholds, in the region that the map was read from. The result
  /// stays good until the next scan.
  std::span<const Component> scan(const Brightness& image, const BlockMap& map);
  /// The same with one threshold for a whole region.
  std::span<const Component> scan(const Brightness& image, const Region& region, std::uint8_t threshold);

 private:
  struct Run {
    int first;
    int last;
    int component;
  };
  void begin();
  void scanRow(const Brightness& image, const BlockMap& map, int row, int y);
  void scanPixels(const Brightness& image, int y, int first, int end, std::uint8_t threshold);
  void endRow();
  void closeRun(const Brightness& image, int y, int last);
  int root(int component);
  void join(int a, int b);
  std::span<const Component> finish();

  std::vector<int> blocks_;   ///< columns of the blocks that stand out in this row of blocks
  std::vector<Run> above_;    ///< runs of the row above
  std::vector<Run> current_;  ///< runs of this row
  std::size_t oldest_ = 0;    ///< first run above that can still touch
  int run_begin_ = -1;        ///< of the run that is open, or -1
  std::uint8_t threshold_ = 0;
  std::vector<Component> components_;
  std::vector<int> parents_;
};

}  // namespace mirrorarm::vision
