#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vision/brightness.h"
#include "core/vision/threshold_map.h"

namespace mirrorarm::vision {

/// Bright pixels that hang together, diagonals included.
struct Component {
  Region box;
  int area_px = 0;
  std::int64_t sum_x = 0;
  std::int64_t sum_y = 0;
  std::uint8_t peak = 0;
  int clipped_px = 0;  ///< pixels at 255

  [[nodiscard]] double x() const { return static_cast<double>(sum_x) / area_px; }
  [[nodiscard]] double y() const { return static_cast<double>(sum_y) / area_px; }
};

/// Finds connected bright components in one pass over run lengths. Keeps its buffers.
class ComponentScanner {
 public:
  /// Components brighter than the map's thresholds; `map` was estimated for this region. The result stays
  /// good until the next scan.
  std::span<const Component> scan(const Brightness& image, const Region& region, const ThresholdMap& map);
  /// The same with one threshold for the whole region.
  std::span<const Component> scan(const Brightness& image, const Region& region, std::uint8_t threshold);

 private:
  struct Run {
    int first;
    int last;
    int component;
  };
  void begin(const Region& region);
  void scanRow(const Brightness& image, int y);
  void addRun(const Brightness& image, int y, int first, int last);
  int root(int component);
  void join(int a, int b);
  std::span<const Component> finish();

  Region region_;
  std::vector<std::uint8_t> thresholds_;
  std::vector<Run> above_;    ///< runs of the row above
  std::vector<Run> current_;  ///< runs of this row
  std::size_t oldest_ = 0;    ///< first run above that can still touch
  std::vector<Component> components_;
  std::vector<int> parents_;
};

}  // namespace mirrorarm::vision
