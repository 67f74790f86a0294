#include <gtest/gtest.h>

#include "core/geometry/rigid_fit.h"
#include "core/tracking/layout.h"
#include "core/tracking/teacher.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

/// Root mean square of taught markers from true ones, each taken with its nearest, in the best common frame;
/// the frames differ by the first pose only.
double misfit(const Target& taught, const std::vector<Vector3d>& truth_T, const RigidTransform& X_CT_first) {
  Vector3d centroid = Vector3d::Zero();
  for (const auto& p : truth_T) centroid += X_CT_first * p / static_cast<double>(truth_T.size());
  std::vector<Vector3d> x, y;
  for (const auto& p : truth_T) {
    const Vector3d expected = X_CT_first * p - centroid;
    const auto nearest = std::min_element(
        taught.markers_T.begin(), taught.markers_T.end(),
        [&](const auto& a, const auto& b) { return (a - expected).norm() < (b - expected).norm(); });
    x.push_back(expected);
    y.push_back(*nearest);
  }
  return fitRms(fitByKabsch(x, y), x, y);
}

}  // namespace

TEST(Teacher, LearnsAMovingArmWithHiddenMarkersAndStrangers) {
  const Target truth = forearm();
  Noise noise(31);
  Teacher teacher{TeacherSettings{}};
  RigidTransform X_CT = noise.pose();
  const RigidTransform first = X_CT;
  teacher.add(look(truth.markers_T, X_CT, 10, 1, noise).points_C);
  for (int frame = 1; frame < 100; ++frame) {
    X_CT = X_CT * noise.nudge(0.1, 0.01);
    teacher.add(look(truth.markers_T, X_CT, 7 + frame % 4, 2, noise).points_C);
  }
  EXPECT_EQ(teacher.frames(), 100);
  EXPECT_EQ(teacher.markers(), 10);
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.name, "forearm");
  ASSERT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_GE(taught->frames_used, 97);
  EXPECT_EQ(taught->frames_used + taught->frames_rejected, 100);
  EXPECT_LT(misfit(taught->target, truth.markers_T, first), 0.00006);
  EXPECT_GT(taught->sigma_m, 0.000005);
  EXPECT_LT(taught->sigma_m, 0.00005);
  Vector3d centroid = Vector3d::Zero();
  for (const auto& p : taught->target.markers_T) centroid += p;
  EXPECT_LT(centroid.norm(), 1e-12);
}

TEST(Teacher, FrameHasTheCamerasAxesAtTheFirstCloud) {
  const Target truth = forearm();
  Noise noise(32);
  const RigidTransform X_CT = noise.pose();
  Teacher teacher{TeacherSettings{}};
  teacher.add(look(truth.markers_T, X_CT, 10, 0, noise).points_C);
  const auto taught = teacher.finish("one shot");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->frames_used, 1);
  EXPECT_EQ(taught->sigma_m, 0.0);
  EXPECT_TRUE(taught->target.markers_covariance_m2.empty());
  std::vector<Vector3d> expected;
  Vector3d centroid = Vector3d::Zero();
  for (const auto& p : truth.markers_T) centroid += X_CT * p / 10.0;
  for (const auto& p : truth.markers_T) expected.push_back(X_CT * p - centroid);
  for (const auto& p : expected) {
    double nearest = 1.0;
    for (const auto& q : taught->target.markers_T) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 0.001);
  }
}

TEST(Teacher, AddsAMarkerThatTheFirstCloudDidNotShow) {
  const Target truth = forearm();
  Noise noise(33);
  Teacher teacher{TeacherSettings{}};
  const RigidTransform X_CT = noise.pose();
  teacher.add(look(truth.markers_T, X_CT, 7, 0, noise).points_C);
  for (int frame = 0; frame < 20; ++frame)
    teacher.add(look(truth.markers_T, X_CT * noise.nudge(0.05, 0.01), 10, 0, noise).points_C);
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
}

TEST(Teacher, LeavesOutCloudsOfAnotherShape) {
  const Target truth = forearm();
  Noise noise(34);
  Teacher teacher{TeacherSettings{}};
  const RigidTransform X_CT = noise.pose();
  for (int frame = 0; frame < 30; ++frame) {
    Target seen = truth;
    if (frame % 10 == 9)
      for (auto& p : seen.markers_T) p += noise.gaussian(0.02);
    teacher.add(look(seen.markers_T, X_CT, 10, 0, noise).points_C);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->frames_rejected, 3);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_LT(misfit(taught->target, truth.markers_T, X_CT), 0.0001);
}

TEST(Teacher, RefusesWhatFixesNoPose) {
  Noise noise(35);
  EXPECT_EQ(Teacher{TeacherSettings{}}.finish("t").error(), TeachingError::kNoFrames);

  Teacher empty{TeacherSettings{}};
  empty.add({});
  empty.add(std::vector<Vector3d>{Vector3d(0, 0, 0.5), Vector3d(0.1, 0, 0.5)});
  EXPECT_EQ(empty.frames(), 2);
  EXPECT_EQ(empty.finish("t").error(), TeachingError::kTooFewMarkers);

  Teacher line{TeacherSettings{}};
  std::vector<Vector3d> on_line;
  for (int i = 0; i < 5; ++i) on_line.emplace_back(0.01 * i * i, 0.0, 0.5);
  for (int frame = 0; frame < 5; ++frame) line.add(on_line);
  EXPECT_EQ(line.finish("t").error(), TeachingError::kCollinear);
  EXPECT_EQ(id(TeachingError::kCollinear), "collinear");

  Teacher broken{TeacherSettings{}};
  broken.add(std::vector<Vector3d>(5, Vector3d::Constant(std::nan(""))));
  EXPECT_EQ(broken.finish("t").error(), TeachingError::kTooFewMarkers);
}

TEST(Teacher, ACrowdOfStrangersEndsInBoundedWork) {
  const Target truth = forearm();
  Noise noise(36);
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 5; ++frame)
    teacher.add(look(truth.markers_T, noise.pose(), 10, 2000, noise).points_C);
  EXPECT_EQ(teacher.frames(), 5);
  EXPECT_LE(teacher.markers(), 64);
}
