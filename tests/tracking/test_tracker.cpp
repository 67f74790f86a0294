#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/camera/stereo_view.h"
#include "core/tracking/tracker.h"
#include "tests/common/no_heap.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;
using namespace std::chrono_literals;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr auto kFrame = 41667us;

/// An arm's smooth motion: 0.7 Hz, 120 mm, with turning.
RigidTransform armAt(double t) {
  const double phase = 2.0 * std::numbers::pi * 0.7 * t;
  return makeTransform(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::sin(phase), Vector3d(0.3, 0.9, 0.3).normalized())),
      Vector3d(0.06 * std::sin(phase), 0.02 * std::cos(phase), 0.5 + 0.02 * std::sin(phase)));
}

bool identitiesRight(const TrackedTarget& answer, const Scene& scene) {
  for (int marker = 0; marker < answer.marker_count; ++marker) {
    const int point = answer.point_of_marker[static_cast<std::size_t>(marker)];
    if (point >= 0 && scene.marker_of_point[static_cast<std::size_t>(point)] != marker) return false;
  }
  return true;
}

Tracker trackerOf(const std::vector<Target>& targets) {
  Tracker tracker{TrackerSettings{}};
  tracker.setTargets(targets);
  return tracker;
}

}  // namespace

TEST(Tracker, FindsTheArmInAnyOrientation) {
  const Target target = forearm();
  Noise noise(11);
  for (int trial = 0; trial < 200; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
    Tracker tracker = trackerOf({target});
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(1s))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << trial;
    EXPECT_EQ(answer.reason, LostReason::kNone);
    EXPECT_EQ(answer.matched_count, 10);
    EXPECT_TRUE(identitiesRight(answer, scene));
    EXPECT_LT((answer.X_CT.translation() - X_CT.translation()).norm(), 0.0003);
    EXPECT_LT(angleBetween(answer.X_CT, X_CT), 0.5 * kDegree);
  }
}

TEST(Tracker, FindsHalfTheMarkersAmongStrangersFromNothing) {
  const Target target = forearm();
  Noise noise(12);
  for (int trial = 0; trial < 300; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 5, 15, noise);
    Tracker tracker = trackerOf({target});
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(1s))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << trial << " " << id(answer.reason);
    EXPECT_TRUE(identitiesRight(answer, scene)) << trial;
    EXPECT_LT((answer.X_CT.translation() - X_CT.translation()).norm(), 0.001);
    EXPECT_LT(angleBetween(answer.X_CT, X_CT), 2.0 * kDegree);
  }
}

TEST(Tracker, SaysAmbiguousWhereTheMarkersFitInTwoWays) {
  Target square = forearm();
  square.markers_T = {
      {0.04, 0.0, 0.0}, {0.0, 0.04, 0.0}, {-0.04, 0.0, 0.0}, {0.0, -0.04, 0.0}, {0.0, 0.0, 0.0}};
  Noise noise(27);
  for (int trial = 0; trial < 20; ++trial) {
    const Scene scene = look(square.markers_T, noise.pose(), 5, 3, noise);
    Tracker tracker = trackerOf({square});
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(1s))[0];
    EXPECT_EQ(answer.status, TrackStatus::kLost);
    EXPECT_EQ(answer.reason, LostReason::kAmbiguous);
  }
}

TEST(Tracker, KeepsTheArmWithThreeMarkersOnceItIsKnown) {
  const Target target = forearm();
  Noise noise(28);
  Tracker tracker = trackerOf({target});
  for (int frame = 0; frame < 120; ++frame) {
    const double t = frame / 24.0;
    const Scene scene = look(target.markers_T, armAt(t), frame < 12 ? 10 : 3 + frame % 2, 2, noise);
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(toClock(Seconds(t))))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << frame << " " << id(answer.reason);
    EXPECT_TRUE(identitiesRight(answer, scene)) << frame;
    EXPECT_LT((answer.X_CT.translation() - armAt(t).translation()).norm(), 0.003) << frame;
  }
}

TEST(Tracker, TellsThatTheArmHasLeftTheView) {
  const auto rig = camera::readRig(std::filesystem::path(RESOURCES) / "rigs/fisheye.yaml").value();
  const Target target = forearm();
  Noise noise(29);
  Tracker tracker = trackerOf({target});
  tracker.setRig(rig);
  TrackedTarget answer;
  for (int frame = 0; frame < 60; ++frame) {
    const double t = frame / 24.0;
    const RigidTransform X_CT =
        makeTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Vector3d(0.0, 0.6 * t, 0.3));
    std::vector<Vector3d> seen;
    for (const auto& p_T : target.markers_T)
      if (camera::bothCamerasSee(rig, X_CT * p_T))
        seen.push_back(X_CT * p_T + noise.gaussian(kSensorNoise_m));
    answer = tracker.track(asStereo(seen), TimePoint(toClock(Seconds(t))))[0];
  }
  EXPECT_EQ(answer.status, TrackStatus::kLost);
  EXPECT_EQ(answer.reason, LostReason::kOutOfVolume);
}

TEST(Tracker, AnswersAtAnyTimeMeasuredOrPredicted) {
  const Target target = forearm();
  Noise noise(30);
  Tracker tracker = trackerOf({target});
  EXPECT_EQ(tracker.at(0, TimePoint(1s)).status, TrackStatus::kLost);
  TimePoint now(1s);
  for (int frame = 0; frame < 24; ++frame, now += kFrame)
    (void)tracker.track(
        asStereo(look(target.markers_T, armAt(secondsBetween(TimePoint(1s), now)), 10, 0, noise).points_C),
        now);
  const TimePoint last = now - kFrame;
  EXPECT_EQ(tracker.at(0, last).status, TrackStatus::kTracked);
  const auto soon = tracker.at(0, last + 30ms);
  EXPECT_EQ(soon.status, TrackStatus::kPredicted);
  const auto truth = armAt(secondsBetween(TimePoint(1s), last + 30ms));
  EXPECT_LT((soon.X_CT.translation() - truth.translation()).norm(), 0.002);
  EXPECT_GT(shiftSigma(soon), shiftSigma(tracker.at(0, last)));
  const auto late = tracker.at(0, last + 300ms);
  EXPECT_EQ(late.status, TrackStatus::kLost);
  EXPECT_EQ(late.reason, LostReason::kStale);
}

TEST(Tracker, FollowsAMovingArmWithHiddenMarkersAndStrangers) {
  const Target target = forearm();
  Noise noise(13);
  Tracker tracker = trackerOf({target});
  double t = 0.0;
  for (int frame = 0; frame < 240; ++frame, t += 1.0 / 24.0) {
    const RigidTransform X_CT = armAt(t);
    const int visible = frame == 0 ? 10 : 5 + frame % 6;
    const Scene scene = look(target.markers_T, X_CT, visible, 6, noise);
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(toClock(Seconds(t))))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << frame << " " << id(answer.reason);
    EXPECT_GE(answer.matched_count, visible);
    EXPECT_LT((answer.X_CT.translation() - X_CT.translation()).norm(), 0.001) << frame;
  }
}

TEST(Tracker, CovarianceTellsTheErrorThatItMakes) {
  const Target target = forearm();
  Noise noise(14);
  const RigidTransform X_CT = noise.pose();
  double chi2 = 0.0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
    Tracker tracker = trackerOf({target});
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(1s))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked);
    const RigidTransform error = answer.X_CT.inverse() * X_CT;
    Eigen::Matrix<double, 6, 1> d;
    d << rotationVector(error.linear()), error.translation();
    chi2 += d.dot(answer.covariance.ldlt().solve(d)) / kTrials;
  }
  // The mean of chi-squared with 6 degrees is 6; the part of the misfit that chance adds makes it a little
  // less.
  EXPECT_GT(chi2, 4.5);
  EXPECT_LT(chi2, 6.6);
}

TEST(Tracker, KeepsTheSkinOfAForearmThatDeforms) {
  const Target target = forearm();
  Noise noise(15);
  std::vector<Vector3d> direction;
  for (int i = 0; i < 10; ++i) direction.push_back(noise.gaussian(0.0016));
  Tracker tracker = trackerOf({target});
  double t = 0.0;
  for (int frame = 0; frame < 120; ++frame, t += 1.0 / 24.0) {
    Target skin = target;
    for (std::size_t i = 0; i < 10; ++i)
      skin.markers_T[i] += std::sin(2.0 * t + static_cast<double>(i)) * direction[i];
    const Scene scene = look(skin.markers_T, armAt(t), 10, 2, noise);
    const auto answer = tracker.track(asStereo(scene.points_C), TimePoint(toClock(Seconds(t))))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << frame << " " << id(answer.reason);
    EXPECT_TRUE(identitiesRight(answer, scene)) << frame;
    EXPECT_GE(answer.matched_count, 8) << frame;
  }
}

TEST(Tracker, CarriesAShortGapOnAndThenSaysLost) {
  const Target target = forearm();
  Noise noise(16);
  Tracker tracker = trackerOf({target});
  TimePoint now(1s);
  const auto poseAt = [](TimePoint time) {
    RigidTransform X = armAt(0.0);
    X.translation().x() += 0.2 * secondsBetween(TimePoint(1s), time);
    return X;
  };
  for (int frame = 0; frame < 10; ++frame, now += kFrame)
    (void)tracker.track(asStereo(look(target.markers_T, poseAt(now), 10, 0, noise).points_C), now);
  const TimePoint last = now - kFrame;
  for (; now - last <= 100ms; now += kFrame) {
    const auto answer = tracker.track({}, now)[0];
    ASSERT_EQ(answer.status, TrackStatus::kPredicted);
    EXPECT_EQ(answer.reason, LostReason::kNoPoints);
    EXPECT_LT((answer.X_CT.translation() - poseAt(now).translation()).norm(), 0.0015);
    EXPECT_GT(answer.covariance(3, 3), 1e-7);
  }
  EXPECT_EQ(tracker.track({}, now)[0].status, TrackStatus::kLost);
}

TEST(Tracker, GivesEachOfTwoArmsItsOwnPoints) {
  const Target first = forearm();
  Target second = first;
  second.name = "upper";
  for (auto& p : second.markers_T) p = Vector3d(1.25 * p.x(), 0.8 * p.z(), -1.1 * p.y());
  const std::vector<Target> both{first, second};
  Tracker tracker = trackerOf(both);
  Noise noise(17);
  for (int frame = 0; frame < 24; ++frame) {
    const double t = frame / 24.0;
    const RigidTransform X_C1 = armAt(t);
    RigidTransform X_C2 = armAt(0.7 * t);
    X_C2.translation().y() += 0.15;
    Scene scene = look(first.markers_T, X_C1, 8, 0, noise);
    const Scene other = look(second.markers_T, X_C2, 8, 0, noise);
    scene.points_C.insert(scene.points_C.end(), other.points_C.begin(), other.points_C.end());
    const auto answers = tracker.track(asStereo(scene.points_C), TimePoint(toClock(Seconds(t))));
    ASSERT_EQ(answers.size(), 2u);
    ASSERT_EQ(answers[0].status, TrackStatus::kTracked);
    ASSERT_EQ(answers[1].status, TrackStatus::kTracked);
    EXPECT_LT((answers[0].X_CT.translation() - X_C1.translation()).norm(), 0.001);
    EXPECT_LT((answers[1].X_CT.translation() - X_C2.translation()).norm(), 0.001);
    std::vector<int> used(scene.points_C.size(), 0);
    for (const auto& answer : answers)
      for (const int point : answer.point_of_marker)
        if (point >= 0) ++used[static_cast<std::size_t>(point)];
    EXPECT_EQ(*std::max_element(used.begin(), used.end()), 1);
  }
}

TEST(Tracker, TheModelIsTaughtAnewWhenTheSleeveSlips) {
  const Target target = forearm();
  Noise noise(18);
  Target slipped = target;
  for (std::size_t i = 0; i < 10; i += 2) slipped.markers_T[i] += noise.gaussian(0.006);
  Tracker tracker = trackerOf({target});
  int told = 0, lost = 0;
  for (int frame = 0; frame < 120; ++frame) {
    const double t = frame / 24.0;
    const auto& markers_T = frame < 48 ? target.markers_T : slipped.markers_T;
    const auto answer = tracker.track(asStereo(look(markers_T, armAt(t), 10, 2, noise).points_C),
                                      TimePoint(toClock(Seconds(t))))[0];
    tracker.learn();
    told += tracker.event(0) == SkinEvent::kSlipped ? 1 : 0;
    lost += answer.status == TrackStatus::kLost ? 1 : 0;
    EXPECT_TRUE(frame < 100 || answer.matched_count == 10) << frame;
  }
  EXPECT_GE(told, 1);
  EXPECT_EQ(lost, 0);
  EXPECT_GE(tracker.version(0), 1);
}

TEST(Tracker, OfPointsThatShareADiscOneAtMostIsMatched) {
  const Target target = forearm();
  Noise noise(25);
  Tracker tracker = trackerOf({target});
  for (int frame = 0; frame < 20; ++frame) {
    // Marker 3 is hidden; what the left disc of marker 0 gives with another right one lies where it should
    // be.
    auto points = asStereo(look(target.markers_T, armAt(0.0), 10, 0, noise).points_C);
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      const auto along = [](const auto& point) { return (armAt(0.0).inverse() * point.p_C).x(); };
      return along(a) < along(b);
    });
    for (int i = 0; i < 10; ++i) points[static_cast<std::size_t>(i)].left = i;
    for (int i = 0; i < 10; ++i) points[static_cast<std::size_t>(i)].right = i;
    points[3].left = 0;
    points[3].p_C += Vector3d(0.0, 0.0, 0.0008);
    points[0].rivals = points[3].rivals = 1;
    const auto answer = tracker.track(points, TimePoint(1s + frame * kFrame))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked);
    EXPECT_EQ(answer.matched_count, 9);
    EXPECT_EQ(answer.point_of_marker[0], 0);
    EXPECT_EQ(answer.point_of_marker[3], -1);
  }
}

TEST(Tracker, GhostsOfRivalPairsDoNotMisleadIt) {
  const Target target = forearm();
  Noise noise(26);
  Tracker tracker = trackerOf({target});
  for (int frame = 0; frame < 100; ++frame) {
    const double t = frame / 24.0;
    const Scene scene = look(target.markers_T, armAt(t), 7, 0, noise);
    auto points = asStereo(scene.points_C);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].left = points[i].right = static_cast<int>(i);
    for (std::size_t i = 0; i + 1 < 7; ++i) {  // each disc also pairs with the next one's, off in depth
      vision::StereoPoint ghost = points[i];
      ghost.right = points[i + 1].right;
      ghost.p_C *= noise.uniform(0.8, 1.2);
      ghost.preferred = false;
      points.push_back(ghost);
    }
    for (auto& point : points) point.rivals = 1;
    const auto answer = tracker.track(points, TimePoint(toClock(Seconds(t))))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << frame;
    EXPECT_GE(answer.matched_count, 6);
    EXPECT_LT((answer.X_CT.translation() - armAt(t).translation()).norm(), 0.001);
  }
}

TEST(Tracker, TakesNothingFromTheHeapOnceItFollows) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  const Target target = forearm();
  Noise noise(24);
  Tracker tracker = trackerOf({target});
  for (int frame = 0; frame < 60; ++frame) {
    const double t = frame / 24.0;
    const auto points = asStereo(look(target.markers_T, armAt(t), 10, 4, noise).points_C);
    const TimePoint exposed_at(toClock(Seconds(t)));
    const auto calls = mirrorarm::testing::heapCallsIn([&] { (void)tracker.track(points, exposed_at); });
    ASSERT_TRUE(frame < 30 || calls == 0) << frame;
  }
}

TEST(Tracker, SeekingAnotherTargetTakesNothingFromTheHeapEither) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  const Target target = forearm();
  Target absent = target;
  absent.name = "absent";
  for (auto& p : absent.markers_T) p = Vector3d(1.3 * p.x(), 0.7 * p.z(), -1.2 * p.y());
  Noise noise(31);
  Tracker tracker = trackerOf({target, absent});
  for (int frame = 0; frame < 90; ++frame) {
    const double t = frame / 24.0;
    const auto points = asStereo(look(target.markers_T, armAt(t), 10, 6, noise).points_C);
    const TimePoint exposed_at(toClock(Seconds(t)));
    const auto calls = mirrorarm::testing::heapCallsIn([&] {
      (void)tracker.track(points, exposed_at);
      tracker.learn();
    });
    ASSERT_TRUE(frame < 60 || calls == 0) << frame;
  }
}

TEST(Tracker, ThePapersMethodTracksToo) {
  const Target target = forearm();
  TrackerSettings settings;
  settings.method = TrackingMethod::kSoftassign;
  Tracker tracker{settings};
  tracker.setTargets({&target, 1});
  Noise noise(19);
  for (int frame = 0; frame < 24; ++frame) {
    const double t = frame / 24.0;
    const auto answer = tracker.track(asStereo(look(target.markers_T, armAt(t), 10, 0, noise).points_C),
                                      TimePoint(toClock(Seconds(t))))[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << frame;
    EXPECT_LT((answer.X_CT.translation() - armAt(t).translation()).norm(), 0.0005);
  }
}

TEST(Tracker, ThePapersMethodTeachesAnewAfterRejections) {
  const Target target = forearm();
  TrackerSettings settings;
  settings.method = TrackingMethod::kSoftassign;
  Tracker tracker{settings};
  tracker.setTargets({&target, 1});
  Noise noise(19);
  Target slipped = target;
  for (auto& p : slipped.markers_T) p += noise.gaussian(0.005);
  TrackedTarget answer;
  for (int frame = 0; frame < 12; ++frame)
    answer = tracker.track(
        asStereo(look(frame < 3 ? target.markers_T : slipped.markers_T, armAt(0.0), 10, 0, noise).points_C),
        TimePoint(1s + frame * kFrame))[0];
  EXPECT_EQ(answer.status, TrackStatus::kTracked);
  EXPECT_EQ(tracker.version(0), 1);
}

TEST(Tracker, AnswersLostForCloudsThatHoldNoArm) {
  const Target target = forearm();
  Noise noise(20);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<Vector3d>> clouds{
      {},
      {Vector3d(nan, nan, nan), Vector3d(0.0, infinite, 0.5)},
      {Vector3d(0.0, 0.0, 0.5)},
      std::vector<Vector3d>(40, Vector3d(0.0, 0.0, 0.5)),
      look(target.markers_T, noise.pose(), 2, 0, noise).points_C,
  };
  for (const auto& cloud : clouds) {
    Tracker tracker = trackerOf({target});
    const auto answer = tracker.track(asStereo(cloud), TimePoint(1s))[0];
    EXPECT_EQ(answer.status, TrackStatus::kLost);
    EXPECT_NE(answer.reason, LostReason::kNone);
    EXPECT_EQ(answer.marker_count, 10);
    EXPECT_EQ(answer.point_of_marker[0], -1);
  }
}

TEST(Tracker, NotANumberAndDoubledPointsDoNotHideTheArm) {
  const Target target = forearm();
  Noise noise(21);
  const RigidTransform X_CT = noise.pose();
  Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
  scene.points_C.insert(scene.points_C.begin(), Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  scene.points_C.insert(scene.points_C.end(), scene.points_C.begin() + 1, scene.points_C.begin() + 11);
  const auto points = asStereo(scene.points_C);
  Tracker tracker = trackerOf({target});
  for (const auto time : {TimePoint(1s), TimePoint(1s + kFrame)}) {
    const auto answer = tracker.track(points, time)[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked);
    EXPECT_EQ(answer.matched_count, 10);
    EXPECT_LT((answer.X_CT.translation() - X_CT.translation()).norm(), 0.0003);
  }
}

TEST(Tracker, TenThousandPointsEndInBoundedWork) {
  const Target target = forearm();
  Noise noise(22);
  const RigidTransform X_CT = armAt(0.0);
  Tracker tracker = trackerOf({target});
  const Scene crowd = look(target.markers_T, X_CT, 10, 10'000, noise);
  const auto crowded = asStereo(crowd.points_C);
  for (int frame = 0; frame < 5; ++frame) (void)tracker.track(crowded, TimePoint(1s + frame * kFrame));
  const auto grid = asStereo(std::vector<Vector3d>(40'000, Vector3d(0.0, 0.0, 0.5)));
  EXPECT_EQ(tracker.track(grid, TimePoint(9s))[0].status, TrackStatus::kLost);
}

TEST(Tracker, TargetsThatFixNoPoseAreLost) {
  Target pair = forearm();
  pair.markers_T.resize(2);
  Target line = forearm();
  for (auto& p : line.markers_T) p = Vector3d(p.x(), 0.0, 0.0);
  Target none;
  const std::vector<Target> targets{pair, line, none};
  Noise noise(23);
  Tracker tracker = trackerOf(targets);
  const auto points = asStereo(look(line.markers_T, armAt(0.0), 10, 0, noise).points_C);
  for (const auto& answer : tracker.track(points, TimePoint(1s)))
    EXPECT_EQ(answer.status, TrackStatus::kLost);
}
