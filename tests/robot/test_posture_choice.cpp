#include <numbers>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/posture_choice.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPi = std::numbers::pi;

double misfit(const RigidTransform& X, const RigidTransform& Y) {
  return (X.matrix() - Y.matrix()).cwiseAbs().maxCoeff();
}

double step(const Joints& one, const Joints& other) { return (one - other).cwiseAbs().maxCoeff(); }

/// Reaching ahead with the flange down, as on the bench.
Joints bench() { return kPi / 180.0 * (Joints(7) << 0.0, -27.6, 0.0, 83.0, 0.0, -69.4, 0.0).finished(); }

class PostureChoices : public ::testing::TestWithParam<const char*> {
 protected:
  /// The bench's posture; the bending joints of the iiwa turn the other way round.
  [[nodiscard]] Joints start() const { return arm_.joints[1].axis.y() < 0.0 ? bench() : Joints(-bench()); }

  ArmDescription arm_ = testing::arm(GetParam());
  SrsArm srs_ = *srsArm(arm_);
  JointRanges ranges_ = jointRanges(arm_);
  PostureChoice choice_{srs_, ranges_};
  Kinematics kinematics_{arm_};
  std::mt19937 random_{21};
};

}  // namespace

TEST_P(PostureChoices, AnyPoseInReachIsAnsweredWithinTheRanges) {
  for (int i = 0; i < 5000; ++i) {
    const RigidTransform X_BF = kinematics_.flange(testing::randomJoints(arm_, random_, 1.0));
    const auto q = choice_.any(X_BF, testing::randomJoints(arm_, random_, 1.0));
    ASSERT_TRUE(q) << i << ' ' << id(q.error());
    ASSERT_TRUE(ranges_.have(*q));
    ASSERT_LE(misfit(kinematics_.flange(*q), X_BF), 1e-9);
  }
}

TEST_P(PostureChoices, TheSeedsOwnPoseMovesNoJointFar) {
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const Joints seed = testing::randomJoints(arm_, random_, 0.95);
    const auto q = choice_.nearest(kinematics_.flange(seed), seed);
    if (!q) {
      ++refused;
      continue;
    }
    ASSERT_LE(misfit(kinematics_.flange(*q), kinematics_.flange(seed)), 1e-9);
    const double aligned = std::min(std::abs(std::sin(seed[1])), std::abs(std::sin(seed[5])));
    if (aligned > 0.1) {
      ASSERT_LE(step(*q, seed), 0.03) << seed.transpose();
    }
  }
  EXPECT_EQ(refused, 0);
}

TEST_P(PostureChoices, NeighbouringPosesGetNeighbouringPostures) {
  Joints q = start();
  const RigidTransform X_start = kinematics_.flange(q);
  for (int i = 0; i <= 3000; ++i) {
    const double t = 0.002 * i;
    RigidTransform X_BF = X_start;
    X_BF.pretranslate(0.12 * Eigen::Vector3d(0.5 * std::cos(t) - 0.5, std::sin(2.0 * t), std::sin(3.0 * t)));
    X_BF.rotate(Eigen::AngleAxisd(0.4 * std::sin(t), Eigen::Vector3d(1.0, 0.5, -0.3).normalized()));
    const auto next = choice_.nearest(X_BF, q);
    ASSERT_TRUE(next) << i << ' ' << id(next.error());
    ASSERT_LE(step(*next, q), 0.03) << i;
    ASSERT_LE(misfit(kinematics_.flange(*next), X_BF), 1e-9);
    q = *next;
  }
}

TEST_P(PostureChoices, ClosedMovementsEndInThePostureInWhichTheyBegan) {
  Joints q = start();
  q[0] += 0.3;
  const RigidTransform X_start = kinematics_.flange(q);
  const auto poseAt = [&](double t) {
    RigidTransform X_BF = X_start;
    X_BF.pretranslate(0.1 * Eigen::Vector3d(std::sin(t), 1.0 - std::cos(t), 0.5 * std::sin(2.0 * t)));
    return X_BF;
  };
  for (int i = 0; i < 500; ++i) q = *choice_.nearest(X_start, q);  // comes to rest
  const Joints before = q;
  ASSERT_LE(step(*choice_.nearest(X_start, q), q), 1e-7);
  for (int round = 0; round < 5; ++round)
    for (int i = 1; i <= 200; ++i) q = *choice_.nearest(poseAt(2.0 * kPi * i / 200.0), q);
  EXPECT_LE(step(q, before), 1e-3);
}

TEST_P(PostureChoices, ElbowIsDrawnAwayFromTheEndOfARange) {
  Joints q = start();
  const RigidTransform X_BF = kinematics_.flange(q);
  const auto postures = SrsPostures::at(srs_, X_BF);
  const double psi = srsWrist(srs_, q).arm_angle;
  const auto aside = postures->branches(psi + 0.9);
  q = *std::min_element(aside.begin(), aside.end(),
                        [&](const Joints& a, const Joints& b) { return step(a, q) < step(b, q); });
  for (int i = 0; i < 1000; ++i) {
    const auto next = choice_.nearest(X_BF, q);
    ASSERT_TRUE(next);
    ASSERT_LE(step(*next, q), 0.01);
    q = *next;
  }
  EXPECT_NEAR(srsWrist(srs_, q).arm_angle, psi, 0.2);
}

TEST_P(PostureChoices, SaysWhyThereIsNone) {
  RigidTransform X_BF = kinematics_.flange(start());
  Joints elsewhere = start();
  elsewhere[3] = -elsewhere[3];
  elsewhere[2] = 2.5;
  EXPECT_TRUE(choice_.any(X_BF, elsewhere));
  X_BF.translation().x() += 3.0;
  EXPECT_EQ(choice_.nearest(X_BF, start()).error(), NoPosture::kOutOfReach);
  EXPECT_EQ(choice_.any(X_BF, start()).error(), NoPosture::kOutOfReach);
  X_BF.translation().x() = std::nan("");
  EXPECT_EQ(choice_.nearest(X_BF, start()).error(), NoPosture::kOutOfReach);
  Joints unknown = start();
  unknown[2] = std::nan("");
  EXPECT_FALSE(choice_.nearest(kinematics_.flange(start()), unknown));

  JointRanges narrow = ranges_;
  narrow.upper[3] = std::min(narrow.upper[3], 1.0);
  narrow.lower[3] = std::max(narrow.lower[3], -1.0);
  const PostureChoice stiff(srs_, narrow);
  EXPECT_EQ(stiff.nearest(kinematics_.flange(start()), start()).error(), NoPosture::kOutsideLimits);

  // The elbow may bend one way alone: from a seed bent the other way every joint must turn over.
  JointRanges one_way = ranges_;
  (start()[3] > 0.0 ? one_way.lower : one_way.upper)[3] = 0.0;
  const PostureChoice bent(srs_, one_way);
  Joints turned_over = start();
  turned_over[3] = -turned_over[3];
  EXPECT_EQ(bent.nearest(kinematics_.flange(turned_over), turned_over).error(), NoPosture::kOnlyWithJump);
  EXPECT_TRUE(bent.any(kinematics_.flange(turned_over), turned_over));
}

TEST_P(PostureChoices, NothingIsTakenFromTheHeap) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const RigidTransform X_BF = kinematics_.flange(testing::randomJoints(arm_, random_, 0.8));
  const Joints seed = start();
  double sum = 0.0;
  EXPECT_EQ(::mirrorarm::testing::heapCallsIn([&] {
              if (const auto q = choice_.nearest(X_BF, seed)) sum += q->sum();
              if (const auto q = choice_.any(X_BF, seed)) sum += q->sum();
            }),
            0U)
      << sum;
}

INSTANTIATE_TEST_SUITE_P(Robots, PostureChoices, ::testing::Values("lbr4plus", "iiwa7", "iiwa14"));

}  // namespace mirrorarm::robot
