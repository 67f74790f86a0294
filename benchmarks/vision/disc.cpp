#include "benchmarks/vision/disc.h"

#include <numbers>

#include <Eigen/Geometry>

namespace mirrorarm::benchmarks::vision {

Disc randomDisc(double diameter_px, double least_ratio, TrialRandom& random) {
  Disc disc;
  const double middle = 0.5 * kDiscImage_px;
  disc.centre_px = {middle + random.uniform(-0.5, 0.5), middle + random.uniform(-0.5, 0.5)};
  const double major = 0.5 * diameter_px;
  const Eigen::Vector2d radii(major, major * random.uniform(least_ratio, 1.0));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.uniform(0.0, std::numbers::pi)).toRotationMatrix();
  disc.axes_px = turn * radii.asDiagonal() * turn.transpose();
  return disc;
}

Light lightOf(const Disc& disc, int side_px) {
  Light light(side_px, side_px, disc.background);
  const Outline outline = disc.cut ? cutEllipseOutline(disc.centre_px, disc.axes_px, *disc.cut)
                                   : ellipseOutline(disc.centre_px, disc.axes_px);
  addSurface(light, outline, disc.spread_px, {disc.contrast, disc.centre_px, disc.slope});
  return light;
}

}  // namespace mirrorarm::benchmarks::vision
