#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include "ui/views/forearm_fit.h"
#include "ui/views/image_cell.h"
#include "ui/views/lathe.h"
#include "ui/views/prop.h"

namespace mirrorarm::ui {
namespace {

/// Ten markers on the side of a cylinder along x that looks to -z, measured with `sigma_m` of noise.
std::vector<Eigen::Vector3d> sleeve(double radius_m, double sigma_m) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, sigma_m);
  std::vector<Eigen::Vector3d> markers;
  for (int i = 0; i < 10; ++i) {
    const double angle = (i * 7 % 10 - 4.5) / 4.5 * 0.87;
    markers.emplace_back(-0.1 + 0.022 * i + noise(random), radius_m * std::sin(angle) + noise(random),
                         -radius_m * std::cos(angle) + noise(random));
  }
  return markers;
}

TEST(ForearmFit, FindsTheCylinderUnderItsMarkers) {
  const auto fit = fitForearm(sleeve(0.045, 0.0002), -Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(fit.radius_m, 0.045, 0.003);
  EXPECT_GT(std::abs(fit.X_TA.linear().col(2).x()), std::cos(0.1)) << "along the arm";
  EXPECT_NEAR(fit.X_TA.translation().z(), 0.0, 0.003) << "the axis, not the skin";
  EXPECT_NEAR(fit.half_length_m, 0.1, 0.005);
  EXPECT_TRUE(isRigid(fit.X_TA));
}

TEST(ForearmFit, TakesAUsualForearmWhereTheMarkersTellNone) {
  std::vector<Eigen::Vector3d> flat;
  for (int i = 0; i < 10; ++i) flat.emplace_back(0.02 * i, 0.01 * (i % 3), 0.0);
  const auto fit = fitForearm(flat, -Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(fit.radius_m, 0.045, 1e-9);
  EXPECT_GT(fit.X_TA.translation().z(), 0.0) << "behind the markers";
  EXPECT_TRUE(isRigid(fit.X_TA));
}

TEST(Lathe, ACapsuleHasItsSize) {
  const auto capsule = lathe(capsuleOutline(0.2, 0.05));
  double bounds[6];
  capsule->GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 0.1, 1e-6);
  EXPECT_NEAR(bounds[4], -0.05, 1e-6);
  EXPECT_NEAR(bounds[5], 0.25, 1e-6);
}

TEST(Prop, AFrameAlongASegmentPointsAtItsEnd) {
  const Eigen::Vector3d from(0.1, 0.2, 0.3), to(0.4, -0.1, 0.3);
  const RigidTransform X = frameAlong(from, to);
  EXPECT_TRUE(isRigid(X));
  EXPECT_NEAR((X * Eigen::Vector3d(0.0, 0.0, (to - from).norm()) - to).norm(), 0.0, 1e-9);
}

TEST(ImageCell, AnImageKeepsItsProportions) {
  const QRectF place = fitted(QSizeF(1296, 964), QRectF(0, 0, 500, 100));
  EXPECT_NEAR(place.height(), 100.0, 1e-9);
  EXPECT_NEAR(place.width() / place.height(), 1296.0 / 964.0, 1e-9);
  EXPECT_NEAR(place.center().x(), 250.0, 1e-9);
}

}  // namespace
}  // namespace mirrorarm::ui
