#include <cmath>

#include <gtest/gtest.h>

#include "benchmarks/vision/disc.h"
#include "core/camera/camera_model.h"
#include "core/simulation/light_image.h"
#include "tests/vision/rendering.h"

namespace mirrorarm::benchmarks::vision {
namespace {

Disc ellipse() {
  Disc disc;
  disc.centre_px = {24.31, 23.62};
  disc.axes_px << 5.0, 0.6, 0.6, 3.8;
  return disc;
}

TEST(Light, AgreesWithSupersampling) {
  const Disc disc = ellipse();
  mirrorarm::vision::Rendering finely(48, 48, disc.background, disc.spread_px);
  finely.disc(disc.centre_px, disc.axes_px, disc.contrast);
  std::mt19937 unused;
  const auto sampled = finely.expose(0.0, unused);
  const Light light = lightOf(disc, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      EXPECT_NEAR(light.grey[static_cast<std::size_t>(y * 48 + x)], sampled.view().at(x, y), 2.3)
          << x << " " << y << ": half a grey value of rounding, 1 % of the contrast of sampling";
}

TEST(Light, AgreesWithTheSimulatedCamera) {
  const Disc disc = ellipse();
  // A disc parallel to the image of a pinhole: 1 m away, one pixel a millimetre.
  const camera::CameraModel pinhole({camera::LensModel::kBrownConrady, 48, 48, 1e3, 1e3, 0, 0, {}});
  simulation::LightImage simulated(pinhole, disc.spread_px);
  simulation::Patch patch;
  patch.centre << 1e-3 * disc.centre_px, 1.0;
  patch.u << 1e-3 * disc.axes_px.col(0), 0.0;
  patch.v << 1e-3 * disc.axes_px.col(1), 0.0;
  simulated.add(patch, disc.contrast);
  const Light light = lightOf(disc, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      EXPECT_NEAR(light.grey[static_cast<std::size_t>(y * 48 + x)] - disc.background, simulated.row(y)[x],
                  2e-3);
}

double sumOf(const Light& light, double background) {
  double sum = 0.0;
  for (const double grey : light.grey) sum += grey - background;
  return sum;
}

TEST(Light, RampKeepsTheLightAndMovesItsCentroid) {
  Disc disc = ellipse();
  disc.axes_px = 5.0 * Eigen::Matrix2d::Identity();
  const double level_sum = sumOf(lightOf(disc, 48), disc.background);
  disc.slope = {0.02, 0.0};
  const Light light = lightOf(disc, 48);
  EXPECT_NEAR(sumOf(light, disc.background), level_sum, 1e-6 * level_sum);
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      moment += (light.grey[static_cast<std::size_t>(y * 48 + x)] - disc.background) * Eigen::Vector2d(x, y);
  const Eigen::Vector2d centroid = moment / level_sum;
  EXPECT_NEAR(centroid.x() - disc.centre_px.x(), 0.02 * 25.0 / 4.0, 1e-6) << "slope times r^2 / 4";
  EXPECT_NEAR(centroid.y() - disc.centre_px.y(), 0.0, 1e-6);
}

TEST(Light, CutKeepsTheFreeSide) {
  Disc disc = ellipse();
  const Light whole = lightOf(disc, 48);
  disc.cut = cutOfArea(0.3, 0.0);
  Light cut = lightOf(disc, 48);
  EXPECT_NEAR(sumOf(cut, disc.background), 0.7 * sumOf(whole, disc.background), 1e-3);
  EXPECT_NEAR(cut.at(20, 23), whole.grey[23 * 48 + 20], 1e-3);
  EXPECT_NEAR(cut.at(29, 24), disc.background, 1.0);
}

}  // namespace
}  // namespace mirrorarm::benchmarks::vision
