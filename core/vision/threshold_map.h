#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vision/brightness.h"

namespace mirrorarm::vision {

/// How bright a pixel must be to stand out from its surroundings, learnt from the image itself: background
/// and noise are quantiles over tiles, so that discs in a tile do not lift them, smoothed by the median of
/// neighbouring tiles and interpolated between. Keeps its buffers.
class ThresholdMap {
 public:
  static constexpr int kTile_px = 32;

  /// Learns from `region` of the image; it must lie inside and not be empty.
  void estimate(const Brightness& image, const Region& region);

  /// Thresholds of row `y` for the columns of the region, one a pixel; 255 lets nothing through.
  void thresholds(int y, std::span<std::uint8_t> row) const;

  /// Background and noise (standard deviation, at least half a grey value) around a pixel of the region.
  [[nodiscard]] float background(double x, double y) const { return nearest(background_, x, y); }
  [[nodiscard]] float noise(double x, double y) const { return nearest(noise_, x, y); }

 private:
  void measureTile(const Brightness& image, int column, int row);
  [[nodiscard]] float nearest(const std::vector<float>& map, double x, double y) const;

  Region region_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> background_;
  std::vector<float> noise_;
  std::vector<float> threshold_;
  std::vector<float> scratch_;
};

}  // namespace mirrorarm::vision
