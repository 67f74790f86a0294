#include <random>

#include <gtest/gtest.h>

#include "core/robot/capsule_distance.h"

namespace mirrorarm::robot {
namespace {

using Eigen::Vector3d;

Vector3d anywhere(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  return {number(random), number(random), number(random)};
}

/// Least distance over points of the segment, refined about the best: from above, exact to the last step.
template <class Distance>
double sampled(const Segment& segment, Distance distance) {
  double from = 0.0, to = 1.0, best = 1e9, at = 0.0;
  for (int round = 0; round < 12; ++round) {
    const double step = (to - from) / 20.0;
    for (int i = 0; i <= 20; ++i) {
      const double t = from + i * step, d = distance(segment.a + t * (segment.b - segment.a));
      if (d < best) best = d, at = t;
    }
    from = std::max(0.0, at - step);
    to = std::min(1.0, at + step);
  }
  return best;
}

double toSegment(const Segment& segment, const Vector3d& point) {
  const Vector3d way = segment.b - segment.a;
  const double t = std::clamp((point - segment.a).dot(way) / std::max(1e-300, way.squaredNorm()), 0.0, 1.0);
  return (segment.a + t * way - point).norm();
}

}  // namespace

TEST(CapsuleDistance, OfSegmentsAgreesWithSampling) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const Segment one{anywhere(random, 1.0), anywhere(random, 1.0)};
    Segment other{anywhere(random, 1.0), anywhere(random, 1.0)};
    if (i % 5 == 0) other.b = other.a + 0.7 * (one.b - one.a);                      // parallel
    if (i % 7 == 0) other.b = other.a;                                              // a point
    if (i % 11 == 0) other.b = other.a + (one.b - one.a) + anywhere(random, 1e-7);  // nearly parallel
    const Nearest found = nearest(one, other);
    const double truth = sampled(one, [&](const Vector3d& p) { return toSegment(other, p); });
    ASSERT_NEAR(found.distance_m, truth, 1e-9) << i;
    ASSERT_NEAR((found.on_first - found.on_second).norm(), found.distance_m, 1e-12);
    ASSERT_LT(toSegment(one, found.on_first), 1e-12);
    ASSERT_LT(toSegment(other, found.on_second), 1e-12);
    ASSERT_NEAR(nearest(other, one).distance_m, found.distance_m, 1e-12);
  }
}

TEST(CapsuleDistance, OfPointsAndCrossedSegments) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  EXPECT_EQ(nearest({x, x}, {x, x}).distance_m, 0.0);
  EXPECT_NEAR(nearest({-x, x}, {-y, y}).distance_m, 0.0, 1e-15);
  EXPECT_NEAR(nearest({-x, x}, {-y + 0.3 * z, y + 0.3 * z}).distance_m, 0.3, 1e-15);
  EXPECT_NEAR(nearest({-x, x}, {2.0 * x, 3.0 * x}).distance_m, 1.0, 1e-15);
}

TEST(CapsuleDistance, OfBoxesAgreesWithSampling) {
  std::mt19937 random(2);
  int through = 0;
  for (int i = 0; i < 5000; ++i) {
    Segment segment{anywhere(random, 1.0), anywhere(random, 1.0)};
    Vector3d half = anywhere(random, 0.5).cwiseAbs();
    if (i % 5 == 0) segment.b[i % 3] = segment.a[i % 3];  // along a face
    if (i % 7 == 0) half.setZero();                       // a point
    if (i % 9 == 0) segment.b = segment.a;
    const Nearest found = nearestToBox(segment, half);
    const auto toBox = [&](const Vector3d& p) { return (p.cwiseAbs() - half).cwiseMax(0.0).norm(); };
    const double truth = sampled(segment, toBox);
    ASSERT_NEAR(std::max(0.0, found.distance_m), truth, 1e-9) << i;
    ASSERT_NEAR((found.on_first - found.on_second).norm(), std::abs(found.distance_m), 1e-12);
    ASSERT_LT(toSegment(segment, found.on_first), 1e-12);
    ASSERT_TRUE((found.on_second.cwiseAbs().array() <= half.array() + 1e-12).all());
    if (found.distance_m < 0.0) ++through;
  }
  EXPECT_GT(through, 300);
}

TEST(CapsuleDistance, ThroughABoxTellsTheWayOut) {
  const Vector3d half(1.0, 2.0, 3.0);
  const Nearest found = nearestToBox({{0.8, -5.0, 0.0}, {0.8, 5.0, 0.0}}, half);
  EXPECT_NEAR(found.distance_m, -0.2, 1e-12);
  EXPECT_NEAR(found.on_second.x(), 1.0, 1e-12);
}

}  // namespace mirrorarm::robot
