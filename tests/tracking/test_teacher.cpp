#include <cmath>
#include <numbers>

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
  empty.add(std::span<const CloudPoint>{});
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

namespace {

/// Long in depth, as a stereo rig measures at 0.4 m to 0.02 px.
const Vector3d kRig_m(0.000013, 0.000014, 0.000071);

CloudPoint measured(const Vector3d& p_C, Noise& noise, SeenDiscs discs = {}) {
  return {p_C + kRig_m.cwiseProduct(noise.gaussian(1.0)), kRig_m.cwiseAbs2().asDiagonal(), discs};
}

/// `hidden` of the markers left out, the others in any order.
std::vector<CloudPoint> shot(const std::vector<Vector3d>& markers_T, const RigidTransform& X_CT, int hidden,
                             Noise& noise) {
  std::vector<CloudPoint> cloud;
  for (const auto& p : markers_T) cloud.push_back(measured(X_CT * p, noise));
  std::shuffle(cloud.begin(), cloud.end(), noise.rng);
  cloud.resize(cloud.size() - static_cast<std::size_t>(hidden));
  return cloud;
}

/// An arm that swings and turns before the camera, at `seconds`.
RigidTransform swing(const RigidTransform& middle, double seconds) {
  const double phase = 2.0 * std::numbers::pi * 0.5 * seconds;
  const Vector3d axis = Vector3d(1.0, 0.4, 0.2).normalized();
  return middle * makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::sin(phase), axis)),
                                Vector3d(0.05 * std::sin(phase), 0.03 * std::sin(0.7 * phase), 0.0));
}

RigidTransform inFront() {
  return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vector3d::UnitX())), Vector3d(0, 0, 0.4));
}

/// How far each taught marker is from its true place once the two shapes are laid on each other; the largest.
double worstError(const Target& taught, const Target& truth, const RigidTransform& X_CT_first) {
  std::vector<Vector3d> x, y;
  Vector3d centroid = Vector3d::Zero();
  for (const auto& p : truth.markers_T)
    centroid += X_CT_first * p / static_cast<double>(truth.markers_T.size());
  for (const auto& p : truth.markers_T) {
    const Vector3d expected = X_CT_first * p - centroid;
    x.push_back(p);
    y.push_back(*std::min_element(
        taught.markers_T.begin(), taught.markers_T.end(),
        [&](const auto& a, const auto& b) { return (a - expected).norm() < (b - expected).norm(); }));
  }
  const RigidTransform X = fitByKabsch(x, y);
  double worst = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, (y[i] - X * x[i]).norm());
  return worst;
}

}  // namespace

TEST(Teacher, IsDoneWhenTheWantedPrecisionIsReached) {
  const Target truth = forearm();
  Noise noise(37);
  Teacher teacher{TeacherSettings{}};
  EXPECT_TRUE(std::isinf(teacher.sigma_m()));
  int frames = 0;
  for (; frames < 300 && !teacher.isDone(); ++frames)
    teacher.add(
        shot(truth.markers_T, swing(inFront(), frames / 24.0), frames % 2 == 0 ? 0 : frames % 5, noise));
  EXPECT_TRUE(teacher.isDone());
  EXPECT_GE(frames, 50);
  EXPECT_LE(frames, 200);
  EXPECT_LE(teacher.sigma_m(), 0.00001);
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->frames_rejected, 0);
  EXPECT_LE(taught->sigma_m, 0.0000105);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.00003);
  for (const double skin : taught->skin_sigma_m) EXPECT_LT(skin, 0.00001);
}

TEST(Teacher, LeavesOutWhatStandsStillWhileTheArmMoves) {
  const Target truth = forearm();
  Noise noise(38);
  std::vector<Vector3d> still_C;
  for (int i = 0; i < 5; ++i) still_C.push_back(noise.stranger(inFront().translation()));
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 150; ++frame) {
    // It rests half of the time.
    const double seconds = frame < 75 ? 0.0 : (frame - 75) / 24.0;
    auto cloud = shot(truth.markers_T, swing(inFront(), seconds), frame % 3, noise);
    for (const auto& p : still_C) cloud.push_back(measured(p, noise));
    teacher.add(cloud);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.00005);
}

TEST(Teacher, LeavesOutAnotherBodyThatMovesOtherwise) {
  const Target truth = forearm();
  Noise noise(39);
  std::vector<Vector3d> other_T;
  for (int i = 0; i < 6; ++i) other_T.push_back(noise.stranger(Vector3d::Zero()));
  const RigidTransform other = makeTransform(noise.rotation(), Vector3d(0.1, 0.05, 0.45));
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 150; ++frame) {
    auto cloud = shot(truth.markers_T, swing(inFront(), frame / 24.0), frame % 3, noise);
    for (const auto& p : shot(other_T, swing(other, 0.7 + 1.3 * frame / 24.0), 0, noise)) cloud.push_back(p);
    teacher.add(cloud);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.00005);
}

TEST(Teacher, GhostsOfRivalPairsDoNotBecomeMarkers) {
  const Target truth = forearm();
  Noise noise(40);
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 100; ++frame) {
    const RigidTransform X_CT = swing(inFront(), frame < 50 ? 0.0 : (frame - 50) / 24.0);
    std::vector<CloudPoint> cloud;
    for (int i = 0; i < 10; ++i)
      cloud.push_back(measured(X_CT * truth.markers_T[static_cast<std::size_t>(i)], noise, {i, i}));
    // The left disc of one with the right disc of another lies elsewhere along the sight.
    cloud.push_back(measured(1.15 * cloud[2].p_C, noise, {2, 7}));
    cloud.push_back(measured(0.9 * cloud[4].p_C, noise, {1, 4}));
    teacher.add(cloud);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.00005);
}

TEST(Teacher, BeginsAnewWhenTheFirstCloudWasNotTheArm) {
  const Target truth = forearm();
  Noise noise(42);
  Teacher teacher{TeacherSettings{}};
  std::vector<CloudPoint> clutter;
  for (int i = 0; i < 5; ++i) clutter.push_back(measured(noise.stranger(Vector3d(0, 0, 0.5)), noise));
  teacher.add(clutter);
  for (int frame = 0; frame < 60; ++frame)
    teacher.add(shot(truth.markers_T, swing(inFront(), frame / 24.0), 0, noise));
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_GT(taught->frames_used, 50);
}

TEST(Teacher, TellsWhichMarkersMoveOnSkinAndHowSureTheyAreThen) {
  const Target truth = forearm();
  Noise noise(43);
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 200; ++frame) {
    Target seen = truth;
    // Two sway with the movement, as over a muscle.
    const double sway = std::sin(2.0 * std::numbers::pi * frame / 40.0);
    seen.markers_T[2] += Vector3d(0.001, 0.0, 0.0005) * sway;
    seen.markers_T[5] += Vector3d(0.0, 0.0008, 0.0) * sway;
    teacher.add(shot(seen.markers_T, swing(inFront(), frame / 24.0), 0, noise));
  }
  EXPECT_FALSE(teacher.isDone());
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  ASSERT_EQ(taught->target.markers_T.size(), 10u);
  int soft = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    if (taught->skin_sigma_m[i] < 0.0001) continue;
    ++soft;
    // 0.8 and 1.1 mm of amplitude along one direction, told as the same in all three.
    EXPECT_NEAR(taught->skin_sigma_m[i], 0.0004, 0.00015);
    EXPECT_GT(taught->target.markers_covariance_m2[i].trace(), 1e-9);
  }
  EXPECT_EQ(soft, 2);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.0002);
}

TEST(Teacher, AThreeMarkerBodyIsLearntWhileItIsFollowed) {
  const std::vector<Vector3d> markers_T{{-0.015, 0.009, -0.019}, {-0.005, -0.036, 0.0}, {0.02, 0.027, 0.019}};
  Noise noise(44);
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 80; ++frame)
    teacher.add(shot(markers_T, swing(inFront(), frame / 60.0), 0, noise));
  const auto taught = teacher.finish("stylus");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 3u);
  EXPECT_GE(taught->frames_used, 75);
}

TEST(Teacher, AFloodOfPointsIsBoundedAndBrokenOnesAreIgnored) {
  const Target truth = forearm();
  Noise noise(45);
  Teacher teacher{TeacherSettings{}};
  for (int frame = 0; frame < 20; ++frame) {
    auto cloud = shot(truth.markers_T, swing(inFront(), frame / 24.0), 0, noise);
    cloud.push_back({Vector3d::Constant(std::nan("")), Eigen::Matrix3d::Zero(), {}});
    cloud.push_back(cloud.front());
    while (frame % 4 == 3 && cloud.size() < 10000)
      cloud.push_back(measured(noise.stranger(inFront().translation()), noise));
    teacher.add(cloud);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_GE(taught->target.markers_T.size(), 10u);
  for (const auto& p : taught->target.markers_T) EXPECT_TRUE(p.allFinite());
}

TEST(Teacher, IsDoneAlsoWhenTheSensorsCovarianceIsNotKnown) {
  const Target truth = forearm();
  Noise noise(46);
  Teacher teacher{TeacherSettings{}};
  int frames = 0;
  for (; frames < 200 && !teacher.isDone(); ++frames) {
    std::vector<Vector3d> cloud_C;
    for (const auto& point : shot(truth.markers_T, swing(inFront(), frames / 24.0), frames % 4, noise))
      cloud_C.push_back(point.p_C);
    cloud_C.emplace_back(0.1, 0.1, 0.5);
    teacher.add(cloud_C);
  }
  EXPECT_TRUE(teacher.isDone());
  EXPECT_LE(frames, 150);
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  EXPECT_EQ(taught->target.markers_T.size(), 10u);
  EXPECT_LT(worstError(taught->target, truth, swing(inFront(), 0.0)), 0.00004);
}
