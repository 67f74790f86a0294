#include <random>

#include <gtest/gtest.h>

#include "core/camera/camera_model.h"

namespace mirrorarm::camera {
namespace {

Intrinsics paperLens() {
  return {LensModel::kBrownConrady, 1296, 964, 720.9, 719.4, 651.7, 478.3, {-0.21, 0.045, 0, 0, 0}};
}
Intrinsics fullBrownConrady() {
  return {LensModel::kBrownConrady,          1296, 964, 720.9, 719.4, 651.7, 478.3,
          {-0.28, 0.09, 8e-4, -5e-4, -0.012}};
}
Intrinsics fisheye() {
  return {LensModel::kKannalaBrandt, 1296, 964, 551.2, 550.7, 640.1, 490.4, {-0.01, 0.002, -5e-4, 1e-4, 0}};
}

class EveryLens : public testing::TestWithParam<Intrinsics> {};

TEST_P(EveryLens, UnprojectInvertsProjectOverTheWholeImage) {
  const CameraModel camera(GetParam());
  for (int y = 0; y < 964; y += 41)
    for (int x = 0; x < 1296; x += 53) {
      const auto point = camera.unproject({x, y});
      ASSERT_TRUE(point) << x << " " << y;
      const auto pixel = camera.project(Eigen::Vector3d(point->x(), point->y(), 1.0) * 0.4);
      ASSERT_TRUE(pixel);
      EXPECT_LT((*pixel - Eigen::Vector2d(x, y)).norm(), 1e-8);
    }
}

TEST_P(EveryLens, UnprojectFindsThePointToTenDigits) {
  const CameraModel camera(GetParam());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> across(-0.55, 0.55);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p_C(across(random), across(random), 1.0);
    const auto pixel = camera.project(p_C);
    ASSERT_TRUE(pixel);
    const auto back = camera.unproject(*pixel);
    ASSERT_TRUE(back);
    EXPECT_LT((*back - p_C.head<2>()).norm(), 1e-10);
  }
}

TEST_P(EveryLens, ProjectJacobianMatchesCentralDifferences) {
  const CameraModel camera(GetParam());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> across(-0.25, 0.25);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p_C(across(random), across(random), 0.45);
    CameraModel::ProjectJacobian J;
    ASSERT_TRUE(camera.project(p_C, J));
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector2d slope = (*camera.project(p_C + step) - *camera.project(p_C - step)) / 2e-6;
      EXPECT_LT((slope - J.col(axis)).norm(), 1e-4) << p_C.transpose();
    }
  }
}

TEST_P(EveryLens, UnprojectJacobianMatchesCentralDifferences) {
  const CameraModel camera(GetParam());
  for (const auto& pixel :
       {Eigen::Vector2d(100, 90), Eigen::Vector2d(645, 480), Eigen::Vector2d(1200, 700)}) {
    CameraModel::UnprojectJacobian J;
    ASSERT_TRUE(camera.unproject(pixel, J));
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = 1e-3 * Eigen::Vector2d::Unit(axis);
      const Eigen::Vector2d slope =
          (*camera.unproject(pixel + step) - *camera.unproject(pixel - step)) / 2e-3;
      EXPECT_LT((slope - J.col(axis)).norm(), 1e-8);
    }
  }
}

TEST_P(EveryLens, AxisProjectsToThePrincipalPointWithARegularJacobian) {
  const CameraModel camera(GetParam());
  CameraModel::ProjectJacobian J;
  const auto pixel = camera.project({0, 0, 0.5}, J);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), GetParam().cx_px, 1e-9);
  EXPECT_NEAR(J(0, 0), GetParam().fx_px / 0.5, 1e-6);
  EXPECT_NEAR(J(1, 1), GetParam().fy_px / 0.5, 1e-6);
}

TEST_P(EveryLens, RefusesWhatIsNotFinite) {
  const CameraModel camera(GetParam());
  const double nan = std::nan("");
  EXPECT_FALSE(camera.project({nan, 0, 1}));
  EXPECT_FALSE(camera.project({0, 0, 0}));
  EXPECT_FALSE(camera.unproject({nan, 3}));
  EXPECT_FALSE(camera.unproject({INFINITY, 3}));
}

INSTANTIATE_TEST_SUITE_P(CameraModel, EveryLens, testing::Values(paperLens(), fullBrownConrady(), fisheye()));

TEST(CameraModel, BrownConradyMatchesTheFormula) {
  const CameraModel camera(fullBrownConrady());
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double radial = 1 - 0.28 * r2 + 0.09 * r2 * r2 - 0.012 * r2 * r2 * r2;
  const auto pixel = camera.project({x * 2, y * 2, 2});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 720.9 * (x * radial + 2 * 8e-4 * x * y - 5e-4 * (r2 + 2 * x * x)) + 651.7, 1e-9);
  EXPECT_NEAR(pixel->y(), 719.4 * (y * radial + 8e-4 * (r2 + 2 * y * y) - 2 * 5e-4 * x * y) + 478.3, 1e-9);
}

TEST(CameraModel, KannalaBrandtSeesBeyondNinetyDegrees) {
  const CameraModel camera(fisheye());
  EXPECT_TRUE(camera.project({1.0, 0.0, -0.05}));
  EXPECT_FALSE(camera.project({0.0, 0.0, -1.0}));
  const auto pixel = camera.project({1.0, 0.0, -0.05});
  EXPECT_FALSE(camera.unproject(*pixel)) << "no point of the plane z = 1 lies there";
}

TEST(CameraModel, BrownConradyStopsWhereTheRadialCurveTurnsBack) {
  Intrinsics barrel = paperLens();
  barrel.distortion = {-0.3, 0.0, 0, 0, 0};
  const CameraModel camera(barrel);
  const double turning = 1.0 / std::sqrt(0.9);
  EXPECT_TRUE(camera.project({turning - 1e-6, 0, 1}));
  EXPECT_FALSE(camera.project({turning + 1e-6, 0, 1}));
  EXPECT_FALSE(camera.project({0.1, 0.1, -1}));
  EXPECT_FALSE(camera.unproject({651.7 + 720.9, 478.3})) << "no ray bends so far out";
}

TEST(CameraModel, LensWithoutDistortionHasNoLimit) {
  Intrinsics pinhole = paperLens();
  pinhole.distortion = {};
  EXPECT_TRUE(CameraModel(pinhole).project({50, 0, 1}));
}

TEST(CameraModel, SeesItsImageOnly) {
  const CameraModel camera(paperLens());
  EXPECT_TRUE(camera.sees({0, 0}));
  EXPECT_TRUE(camera.sees({1295, 963}));
  EXPECT_FALSE(camera.sees({1295.1, 5}));
  EXPECT_FALSE(camera.sees({4, 5}, 5));
}

TEST(CameraModel, NamesComeBack) {
  EXPECT_EQ(lensModelOf(name(LensModel::kKannalaBrandt)), LensModel::kKannalaBrandt);
  EXPECT_EQ(lensModelOf(name(LensModel::kBrownConrady)), LensModel::kBrownConrady);
  EXPECT_FALSE(lensModelOf("pinhole"));
}

}  // namespace
}  // namespace mirrorarm::camera
