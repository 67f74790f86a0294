#include <algorithm>

#include <gtest/gtest.h>

#include "core/vision/disc_orientation.h"
#include "disc_images.h"
#include "stereo_bench.h"

namespace mirrorarm::vision {
namespace {

class Orientation : public testing::TestWithParam<camera::LensModel> {
 protected:
  struct Look {
    ImagedPoint images;
    DetectedMarker left, right;
  };
  Look look(const WorldDisc& disc, double sigma_px) {
    return {*imaged(rig_, disc.p_C), markerOf(rig_.left, RigidTransform::Identity(), disc, sigma_px, random_),
            markerOf(rig_.right, rig_.X_RC, disc, sigma_px, random_)};
  }
  static double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::acos(std::min(1.0, a.dot(b)));
  }

  camera::StereoRig rig_ = benchRig(GetParam());
  std::mt19937 random_{42};
};

TEST_P(Orientation, PerfectOutlinesGiveTheNormalAndTheRadius) {
  for (int i = 0; i < 100; ++i) {
    const auto disc = anyDisc(random_, 0.3 + 0.003 * i);
    const auto seen = look(disc, 0.0);
    const auto found = discOrientation(seen.images, seen.left, seen.right);
    ASSERT_TRUE(found);
    EXPECT_LT(angle(found->normal_C, disc.normal_C), 0.01);
    EXPECT_NEAR(found->radius_m, disc.radius_m, 2e-6);
    EXPECT_LT(found->misfit, 0.1);
  }
}

TEST_P(Orientation, NoiseStaysWithinItsCovarianceAndTheMirrorImageIsNotTaken) {
  for (const double depth_m : {0.3, 0.6}) {
    double normalised = 0.0, misfit = 0.0;
    int mirrored = 0;
    const int discs = 600;
    for (int i = 0; i < discs; ++i) {
      const auto disc = anyDisc(random_, depth_m);
      const auto seen = look(disc, 0.05);
      const auto found = discOrientation(seen.images, seen.left, seen.right);
      ASSERT_TRUE(found);
      const Eigen::Vector3d error = found->radius_m * found->normal_C - disc.radius_m * disc.normal_C;
      normalised += error.dot(found->covariance_m2.inverse() * error);
      misfit += found->misfit;
      mirrored += angle(found->normal_C, disc.normal_C) > 0.5 ? 1 : 0;
    }
    EXPECT_GT(normalised / (3.0 * discs), 0.5);
    EXPECT_LT(normalised / (3.0 * discs), 1.2);
    EXPECT_LT(misfit / (3.0 * discs), 1.2);
    EXPECT_GT(misfit / (3.0 * discs), 0.5);
    EXPECT_LE(mirrored, discs / 100);
  }
}

TEST_P(Orientation, OutlinesOfTwoDifferentDiscsDoNotAgree) {
  WorldDisc small, large;
  small.p_C = large.p_C = {0.06, 0.01, 0.4};
  large.radius_m = 0.0045;
  const auto a = look(small, 0.01), b = look(large, 0.01);
  EXPECT_GT(discOrientation(a.images, a.left, b.right)->misfit, 100.0);
  WorldDisc tilted_disc = small;
  tilted_disc.normal_C = tilted({0, 0, 1}, 0.9, 1.2);
  const auto c = look(tilted_disc, 0.01);
  EXPECT_GT(discOrientation(a.images, a.left, c.right)->misfit, 100.0);
}

TEST_P(Orientation, ACentresCovarianceStandsInForAnUnknownShapeCovariance) {
  const auto disc = anyDisc(random_, 0.4);
  auto seen = look(disc, 0.01);
  const auto known = discOrientation(seen.images, seen.left, seen.right);
  seen.left.shape_covariance_px4.setZero();
  seen.right.shape_covariance_px4.setZero();
  const auto assumed = discOrientation(seen.images, seen.left, seen.right);
  ASSERT_TRUE(known && assumed);
  EXPECT_LT(angle(assumed->normal_C, known->normal_C), 0.05);
  EXPECT_GT(assumed->covariance_m2.trace(), 0.5 * known->covariance_m2.trace());
}

TEST_P(Orientation, AnOutlineWithoutAnAreaTellsNothing) {
  auto seen = look(anyDisc(random_, 0.4), 0.0);
  seen.right.ellipse.semi_minor_px = 0.0;
  EXPECT_FALSE(discOrientation(seen.images, seen.left, seen.right));
  seen.right.ellipse.semi_minor_px = std::nan("");
  EXPECT_FALSE(discOrientation(seen.images, seen.left, seen.right));
}

INSTANTIATE_TEST_SUITE_P(DiscOrientation, Orientation,
                         testing::Values(camera::LensModel::kBrownConrady,
                                         camera::LensModel::kKannalaBrandt));

}  // namespace
}  // namespace mirrorarm::vision
