#include <algorithm>

#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/vision/centre_correction.h"
#include "disc_images.h"

namespace mirrorarm::vision {
namespace {

class EveryLens : public testing::TestWithParam<const char*> {
 protected:
  camera::StereoRig rig_ = *camera::readRig(std::string(RESOURCES) + "/rigs/" + GetParam());
  std::mt19937 random_{41};
};

TEST_P(EveryLens, BiasIsThatOfADenseFitOverTheWholeField) {
  std::uniform_real_distribution<double> even(0.0, 1.0);
  const auto& camera = rig_.left;
  double largest_px = 0.0;
  int discs = 0;
  for (int i = 0; i < 400; ++i) {
    const auto slope = camera.unproject({10.0 + 1275.0 * even(random_), 10.0 + 943.0 * even(random_)});
    if (!slope) continue;
    WorldDisc disc;
    disc.p_C = (0.25 + 0.35 * even(random_)) * slope->homogeneous().normalized();
    disc.normal_C =
        tilted(disc.p_C, std::acos(1.0 - 0.5 * even(random_)), 2.0 * std::numbers::pi * even(random_));
    const auto outline = outlineOf(camera, RigidTransform::Identity(), disc, 200);
    if (outline.empty()) continue;
    const Eigen::Vector2d truth = denseFit(outline).centre_px - *camera.project(disc.p_C);
    const auto bias = centreBias(camera, {disc.p_C, disc.normal_C, disc.radius_m});
    ASSERT_TRUE(bias);
    EXPECT_LT((*bias - truth).norm(), 2e-4);
    largest_px = std::max(largest_px, truth.norm());
    ++discs;
  }
  EXPECT_GT(discs, 300);
  EXPECT_GT(largest_px, 0.04) << "worth correcting";
}

TEST_P(EveryLens, PhysicalCentreUndoesTheBias) {
  const FlatDisc disc{{0.1, -0.05, 0.3}, tilted({0.1, -0.05, 0.3}, 0.7, 1.0), 0.0035};
  const Eigen::Vector2d truth = *rig_.left.project(disc.p_K);
  const auto outline = outlineOf(rig_.left, RigidTransform::Identity(), {disc.p_K, disc.normal_K}, 200);
  EXPECT_LT((physicalCentre(rig_.left, denseFit(outline).centre_px, disc) - truth).norm(), 2e-4);
}

INSTANTIATE_TEST_SUITE_P(CentreCorrection, EveryLens, testing::Values("fisheye.yaml", "pinhole.yaml"));

TEST(CentreCorrection, OutsideTheLensModelNothingIsCorrected) {
  const auto rig = *camera::readRig(std::string(RESOURCES) + "/rigs/pinhole.yaml");
  const FlatDisc behind{{0.0, 0.0, -0.3}, Eigen::Vector3d::UnitZ(), 0.0035};
  EXPECT_FALSE(centreBias(rig.left, behind));
  EXPECT_EQ(physicalCentre(rig.left, {3.0, 4.0}, behind), Eigen::Vector2d(3.0, 4.0));
  const FlatDisc nowhere{{std::nan(""), 0.0, 0.3}, -Eigen::Vector3d::UnitZ(), 0.0035};
  EXPECT_FALSE(centreBias(rig.left, nowhere));
  EXPECT_FALSE(centreBias(rig.left, {{0.0, 0.0, 0.3}, -Eigen::Vector3d::UnitZ(), 0.0}));
}

}  // namespace
}  // namespace mirrorarm::vision
