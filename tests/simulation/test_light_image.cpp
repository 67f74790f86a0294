#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/simulation/counter_random.h"
#include "core/simulation/light_image.h"

namespace mirrorarm::simulation {
namespace {

struct Moments {
  double mass = 0.0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

Moments momentsOf(const LightImage& light) {
  Moments m;
  for (const auto& box : light.lit())
    for (int y = box.top; y < box.bottom; ++y)
      for (int x = box.left; x < box.right; ++x) {
        const double value = light.row(y)[x];
        m.mass += value;
        m.centre += value * Eigen::Vector2d(x, y);
      }
  m.centre /= m.mass;
  return m;
}

/// Mass and centroid of the projected disc by brute force: the disc cut into small pieces, each projected
/// through the lens and weighted with its own magnification.
Moments projectedArea(const camera::CameraModel& camera, const Patch& patch) {
  Moments m;
  constexpr int kRings = 60, kSpokes = 240;
  for (int i = 0; i < kRings; ++i)
    for (int k = 0; k < kSpokes; ++k) {
      const double r = (i + 0.5) / kRings, angle = 2.0 * std::numbers::pi * k / kSpokes;
      const Eigen::Vector3d p = patch.centre + r * (std::cos(angle) * patch.u + std::sin(angle) * patch.v);
      camera::CameraModel::ProjectJacobian J;
      const Eigen::Vector2d pixel = *camera.project(p, J);
      Eigen::Matrix2d magnification;
      magnification << J * patch.u, J * patch.v;
      const double area =
          std::abs(magnification.determinant()) * r * (1.0 / kRings) * (2.0 * std::numbers::pi / kSpokes);
      m.mass += area;
      m.centre += area * pixel;
    }
  m.centre /= m.mass;
  return m;
}

Disc discOfFrame(std::uint64_t i) {
  const auto within = [&](std::uint64_t k, double low, double high) {
    return low + (high - low) * counterUniform(i, k);
  };
  Disc disc;
  disc.p_B = {within(0, -0.2, 0.2), within(1, -0.15, 0.15), within(2, 0.3, 0.6)};
  disc.normal_B =
      (-disc.p_B.normalized() + 0.8 * Eigen::Vector3d(within(3, -1, 1), within(4, -1, 1), 0.0)).normalized();
  return disc;
}

class LightImageTest : public ::testing::TestWithParam<const char*> {
 protected:
  camera::StereoRig rig_ = *camera::readRig(std::filesystem::path(RESOURCES) / "rigs" / GetParam());
};

TEST_P(LightImageTest, TheCentreIsThatOfTheProjectedDisc) {
  LightImage light(rig_.left, 0.7);
  double worst_px = 0.0, worst_mass = 0.0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Patch patch = patchOf(discOfFrame(i));
    light.clear();
    light.add(patch, 1.0);
    const Moments rendered = momentsOf(light), truth = projectedArea(rig_.left, patch);
    worst_px = std::max(worst_px, (rendered.centre - truth.centre).norm());
    worst_mass = std::max(worst_mass, std::abs(rendered.mass / truth.mass - 1.0));
  }
  EXPECT_LT(worst_px, 0.001);
  EXPECT_LT(worst_mass, 0.001);
}

TEST_P(LightImageTest, FullInsideAndDarkOutside) {
  LightImage light(rig_.left, 0.7);
  Disc disc;
  disc.p_B = {0.01, -0.02, 0.4};
  disc.normal_B = -disc.p_B;
  disc.diameter_m = 0.03;
  light.add(patchOf(disc), 150.0);
  const Eigen::Vector2i middle = rig_.left.project(disc.p_B)->array().round().cast<int>();
  EXPECT_NEAR(light.row(middle.y())[middle.x()], 150.0, 0.01);
  const auto& box = light.lit().front();
  for (int x = box.left; x < box.right; ++x) EXPECT_NEAR(light.row(box.top)[x], 0.0, 0.01);
  EXPECT_EQ(light.row(box.top - 1)[middle.x()], 0.0F);
}

TEST_P(LightImageTest, ATapeIsAsBrightAsItsArea) {
  LightImage light(rig_.left, 0.7);
  Patch tape;
  tape.centre = {0.03, 0.02, 0.8};
  tape.u = {0.06, 0.01, 0.0};
  tape.v = {-0.001, 0.006, 0.0};
  tape.outline = Patch::Outline::kRectangle;
  light.add(tape, 1.0);
  Moments pieces;
  for (int i = -50; i < 50; ++i)
    for (int k = -10; k < 10; ++k) {
      camera::CameraModel::ProjectJacobian J;
      const auto pixel =
          rig_.left.project(tape.centre + (i + 0.5) / 50 * tape.u + (k + 0.5) / 10 * tape.v, J);
      Eigen::Matrix2d magnification;
      magnification << J * tape.u, J * tape.v;
      pieces.mass += std::abs(magnification.determinant()) / 500.0;
      pieces.centre += *pixel * std::abs(magnification.determinant()) / 500.0;
    }
  const Moments rendered = momentsOf(light);
  EXPECT_NEAR(rendered.mass / pieces.mass, 1.0, 0.002);
  EXPECT_LT((rendered.centre - pieces.centre / pieces.mass).norm(), 0.05);
}

TEST_P(LightImageTest, PatchesAtTheBorderAndBehindDoNoHarm) {
  LightImage light(rig_.left, 0.7);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Disc disc = discOfFrame(i);
    disc.p_B = 1.5 * Eigen::Vector3d(counterUniform(i, 7) - 0.5, counterUniform(i, 8) - 0.5,
                                     counterUniform(i, 9) - 0.5);
    disc.diameter_m = 0.1 * counterUniform(i, 10);
    light.add(patchOf(disc), 1.0);
    for (const auto& box : light.lit()) {
      EXPECT_GE(box.left, 0);
      EXPECT_LE(box.right, 1296);
      EXPECT_GE(box.top, 0);
      EXPECT_LE(box.bottom, 964);
    }
    light.clear();
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, LightImageTest, ::testing::Values("fisheye.yaml", "pinhole.yaml"),
                         [](const auto& tested) {
                           return std::string(tested.param).substr(0, std::string(tested.param).find('.'));
                         });

}  // namespace
}  // namespace mirrorarm::simulation
