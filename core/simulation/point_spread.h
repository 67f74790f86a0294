#pragma once

#include <vector>

namespace mirrorarm::simulation {

/// How a point of light spreads over a row of pixels: the lens's Gaussian, then the square of the pixel.
class PointSpread {
 public:
  explicit PointSpread(double sigma_px);

  /// Share of the light that a pixel `u_px` away from it takes.
  [[nodiscard]] float line(double u_px) const { return at(line_, u_px); }
  /// Share that a pixel takes of light that fills everything up to `u_px` short of its centre: 0 far below
  /// the edge, 1 far above. The integral of line().
  [[nodiscard]] float edge(double u_px) const { return at(edge_, u_px); }
  /// Beyond it line() is 0 and edge() is 0 or 1.
  [[nodiscard]] double reach_px() const { return reach_px_; }

 private:
  [[nodiscard]] float at(const std::vector<float>& table, double u_px) const;

  double reach_px_ = 0.0;
  std::vector<float> line_;
  std::vector<float> edge_;
};

}  // namespace mirrorarm::simulation
