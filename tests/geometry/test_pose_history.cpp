#include <gtest/gtest.h>

#include "core/geometry/pose_history.h"

using namespace mirrorarm;
using namespace std::chrono_literals;

namespace {

TimePoint at(std::chrono::milliseconds time) { return TimePoint(10s + time); }

/// Moves 1 m/s along x and turns 1 rad/s about z.
RigidTransform poseAt(double seconds) {
  return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(seconds, Eigen::Vector3d::UnitZ())),
                       Eigen::Vector3d(seconds, 0.0, 0.0));
}

PoseHistory tenPoses() {
  PoseHistory history;
  for (int i = 0; i < 10; ++i) history.add(at(i * 10ms), poseAt(0.01 * i));
  return history;
}

}  // namespace

TEST(PoseHistory, IsEmptyAtFirst) {
  EXPECT_EQ(PoseHistory().size(), 0u);
  EXPECT_FALSE(PoseHistory().at(at(0ms), Seconds(1.0)));
}

TEST(PoseHistory, InterpolatesBetweenItsPoses) {
  const auto history = tenPoses();
  for (const int ms : {0, 3, 10, 47, 89, 90}) {
    const auto X = history.at(at(std::chrono::milliseconds(ms)));
    ASSERT_TRUE(X) << ms;
    EXPECT_LT((X->matrix() - poseAt(0.001 * ms).matrix()).norm(), 1e-9) << ms;
  }
}

TEST(PoseHistory, AnswersOutsideOnlyWithinTheTolerance) {
  const auto history = tenPoses();
  EXPECT_FALSE(history.at(at(-1ms)));
  EXPECT_FALSE(history.at(at(91ms)));
  EXPECT_FALSE(history.at(at(96ms), Seconds(0.005)));
  ASSERT_TRUE(history.at(at(95ms), Seconds(0.005)));
  EXPECT_LT((history.at(at(95ms), Seconds(0.005))->matrix() - poseAt(0.09).matrix()).norm(), 1e-12);
  ASSERT_TRUE(history.at(at(-5ms), Seconds(0.005)));
}

TEST(PoseHistory, IgnoresATimeThatDoesNotRise) {
  auto history = tenPoses();
  history.add(at(90ms), poseAt(5.0));
  history.add(at(20ms), poseAt(5.0));
  EXPECT_EQ(history.size(), 10u);
  EXPECT_LT((history.at(at(90ms))->matrix() - poseAt(0.09).matrix()).norm(), 1e-12);
}

TEST(PoseHistory, ForgetsTheOldestWhenFull) {
  PoseHistory history;
  for (int i = 0; i < 3000; ++i) history.add(at(std::chrono::milliseconds(i)), poseAt(0.001 * i));
  EXPECT_LT(history.size(), 3000u);
  EXPECT_FALSE(history.at(at(100ms)));
  const auto oldest = 3000 - static_cast<int>(history.size());
  for (const int ms : {oldest, oldest + 1, 2500, 2999}) {
    const auto X = history.at(at(std::chrono::milliseconds(ms)));
    ASSERT_TRUE(X) << ms;
    EXPECT_LT((X->matrix() - poseAt(0.001 * ms).matrix()).norm(), 1e-9) << ms;
  }
}
