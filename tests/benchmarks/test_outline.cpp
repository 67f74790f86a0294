#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "benchmarks/vision/outline.h"

namespace mirrorarm::benchmarks::vision {
namespace {

double areaOf(const Outline& outline) {
  double area = 0.0;
  for (const OutlineNode& node : outline) area += node.x * node.dy;
  return area;
}

const Eigen::Vector2d kCentre(7.3, -2.1);
const Eigen::Matrix2d kAxes = (Eigen::Matrix2d() << 5.0, 0.8, 0.8, 3.7).finished();

TEST(Outline, EllipseHasItsArea) {
  EXPECT_NEAR(areaOf(ellipseOutline(kCentre, kAxes)), std::numbers::pi * kAxes.determinant(), 1e-9);
}

TEST(Outline, CutCoversItsShareOfTheArea) {
  const double whole = std::numbers::pi * kAxes.determinant();
  for (const double share : {0.1, 0.25, 0.4, 0.5, 0.9})
    for (const double direction : {0.0, 1.1, 2.9, 5.0}) {
      const Cut cut = cutOfArea(share, direction);
      EXPECT_NEAR(areaOf(cutEllipseOutline(kCentre, kAxes, cut)), (1.0 - share) * whole, 1e-7 * whole)
          << share << " " << direction;
    }
}

TEST(Outline, HalfOfAnUprightDiscIsLeft) {
  const Cut cut = cutOfArea(0.5, 0.0);
  EXPECT_NEAR(cut.limit, 0.0, 1e-12);
  for (const OutlineNode& node : cutEllipseOutline(Eigen::Vector2d::Zero(), kAxes, cut))
    EXPECT_LT((kAxes.inverse() * Eigen::Vector2d(node.x, node.y)).x(), 1e-9);
}

TEST(Outline, PolygonHasItsArea) {
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {9, 0}, {9, 2}, {2, 2}, {2, 7}, {0, 7}};
  EXPECT_NEAR(areaOf(polygonOutline(corners)), 28.0, 1e-10);
}

}  // namespace
}  // namespace mirrorarm::benchmarks::vision
