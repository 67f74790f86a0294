#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "core/devices/fri_joints.h"
#include "core/devices/fri_session.h"
#include "core/robot/urdf.h"
#include "tests/common/no_heap.h"

namespace mirrorarm::devices {
namespace {

using robot::Joints;
using robot::LinkFault;

const Joints kHome = (Joints(7) << 0.1, 0.5, -0.2, 1.2, 0.0, -0.7, 0.3).finished();

/// A session and the datagrams of an ideal controller.
class FriSessionTest : public ::testing::Test {
 protected:
  FriSessionTest() {
    datagram_.state = FriState::kMonitor;
    datagram_.quality = FriQuality::kPerfect;
    datagram_.measurement_period_s = 0.001F;
    datagram_.drives_on = 0x7F;
    datagram_.control = FriControl::kPosition;
    datagram_.commanded_q_rad = datagram_.q_rad = friJointsOf(kHome);
  }

  /// One cycle; with a command where `wish` is not empty.
  Expected<void, LinkFault> cycle(const Joints& wish = {}) {
    ++datagram_.sequence;
    EXPECT_TRUE(session_.take(datagram_));
    Expected<void, LinkFault> taken;
    if (wish.size() > 0) taken = session_.command({wish, compliance_});
    answer_ = session_.answer();
    return taken;
  }
  void commanding() {
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(cycle(kHome));
    EXPECT_EQ(answer_.from_host.integers[1], 1);
    datagram_.state = FriState::kCommand;
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(cycle(kHome));
    ASSERT_EQ(session_.phase(), FriPhase::kCommanding);
  }
  /// Moves all joints at 0.1 rad/s.
  Joints moving(int cycles) { return kHome + Joints::Constant(7, 1e-4 * cycles); }
  double sentFrom(const Joints& q) const { return (jointsOf(answer_.q_rad) - q).cwiseAbs().maxCoeff(); }
  void expectFallen(FriFall why, LinkFault fault) {
    EXPECT_EQ(session_.phase(), FriPhase::kFallen);
    EXPECT_EQ(session_.fall(), why) << id(session_.fall());
    EXPECT_EQ(session_.fault(), fault);
    EXPECT_EQ(answer_.from_host.integers[1], 0);
    EXPECT_EQ(cycle(kHome).error(), fault) << "it does not go on by itself";
  }

  FriSession session_{{}};
  FriMeasurement datagram_;
  robot::Compliance compliance_;
  FriCommand answer_;
};

TEST_F(FriSessionTest, MirrorsWhatAMonitoringControllerHolds) {
  datagram_.commanded_q_offset_rad.fill(0.25F);
  datagram_.q_rad.fill(2.0F);
  cycle();
  EXPECT_EQ(session_.phase(), FriPhase::kMonitoring);
  EXPECT_LT(sentFrom(kHome + Joints::Constant(7, 0.25)), 1e-6);
  EXPECT_EQ(answer_.flags, kFriJointPosition);
  EXPECT_EQ(answer_.reflected, datagram_.sequence);
  EXPECT_EQ(answer_.from_host.integers[0], 10);
  EXPECT_EQ(answer_.from_host.integers[1], 0);
  const auto sequence = answer_.sequence;
  cycle();
  EXPECT_EQ(answer_.sequence, sequence + 1);
}

TEST_F(FriSessionTest, MirrorsWhileTheDrivesAreOff) {
  commanding();
  datagram_.drives_on = 0;
  datagram_.commanded_q_offset_rad.fill(0.01F);
  cycle();
  EXPECT_LT(sentFrom(kHome + Joints::Constant(7, 0.01)), 1e-6);
  expectFallen(FriFall::kDrivesOff, LinkFault::kNotReady);
}

TEST_F(FriSessionTest, AsksForTheStartOnlyWithPerfectQuality) {
  datagram_.quality = FriQuality::kOk;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(cycle(kHome));
  EXPECT_EQ(answer_.from_host.integers[1], 0);
  datagram_.quality = FriQuality::kPerfect;
  cycle(kHome);
  EXPECT_EQ(answer_.from_host.integers[1], 1);
}

TEST_F(FriSessionTest, WaitsUntilTheProgramHasForgottenTheLastStart) {
  datagram_.to_host.integers[1] = 1;
  ASSERT_TRUE(cycle(kHome));
  EXPECT_EQ(answer_.from_host.integers[1], 0);
  datagram_.to_host.integers[1] = 0;
  cycle(kHome);
  EXPECT_EQ(answer_.from_host.integers[1], 1);
}

TEST_F(FriSessionTest, TheFirstCommandEqualsWhatTheControllerHolds) {
  datagram_.commanded_q_rad = friJointsOf(kHome + Joints::Constant(7, 0.005));  // gravity bends the springs
  commanding();
  EXPECT_LT(sentFrom(kHome + Joints::Constant(7, 0.005)), 1e-6);
  ASSERT_TRUE(cycle(moving(1)));
  EXPECT_LT(sentFrom(moving(1) + Joints::Constant(7, 0.005)), 1e-6);
}

TEST_F(FriSessionTest, NothingMovesBeforeTheControllerTakesCommands) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(cycle(kHome));
  EXPECT_EQ(cycle(kHome + Joints::Constant(7, 0.002)).error(), LinkFault::kNotReady);
  EXPECT_LT(sentFrom(kHome), 1e-6);
  expectFallen(FriFall::kMovedEarly, LinkFault::kNotReady);
}

TEST_F(FriSessionTest, AStartPoseThatDiffersIsRefused) {
  datagram_.commanded_q_rad[3] += 0.1F;
  EXPECT_EQ(cycle(kHome).error(), LinkFault::kDriveFault);
  expectFallen(FriFall::kStartPose, LinkFault::kDriveFault);
}

TEST_F(FriSessionTest, AControllerThatShiftsWhileItStartsIsRefused) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(cycle(kHome));
  datagram_.state = FriState::kCommand;
  datagram_.commanded_q_rad[3] += 0.1F;
  for (int i = 0; i < 20 && session_.phase() == FriPhase::kStarting; ++i) cycle(kHome);
  expectFallen(FriFall::kStartPose, LinkFault::kDriveFault);
}

TEST_F(FriSessionTest, AProgramThatNeverStartsIsGivenUp) {
  for (int i = 0; i < 10'002 && session_.phase() != FriPhase::kFallen; ++i) cycle(kHome);
  expectFallen(FriFall::kNotStarted, LinkFault::kNotReady);
}

TEST_F(FriSessionTest, RefusesAnotherCycleThanWasAgreed) {
  datagram_.measurement_period_s = 0.004F;
  EXPECT_EQ(cycle(kHome).error(), LinkFault::kNotReady);
  expectFallen(FriFall::kWrongPeriod, LinkFault::kNotReady);
}

TEST_F(FriSessionTest, ACycleWithoutACommandBrakesToRest) {
  commanding();
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(cycle(moving(i)));
  Joints before = jointsOf(answer_.q_rad);
  double last_step = 1e-4;
  for (int i = 0; i < 40; ++i) {
    cycle();
    const double step = (jointsOf(answer_.q_rad) - before)[0];
    EXPECT_LE(step, last_step + 1e-6);
    EXPECT_NEAR(last_step - step, std::min(4e-6, last_step), 1e-6) << "4 rad/s^2";
    before = jointsOf(answer_.q_rad);
    last_step = step;
  }
  EXPECT_LT(std::abs(last_step), 1e-7);
}

TEST_F(FriSessionTest, HaltBrakesAndAsksForTheStop) {
  commanding();
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(cycle(moving(i)));
  session_.halt();
  cycle();
  EXPECT_EQ(session_.phase(), FriPhase::kStopping);
  EXPECT_EQ(answer_.from_host.integers[1], 0);
  EXPECT_EQ(cycle(moving(21)).error(), LinkFault::kNotReady);
  datagram_.state = FriState::kMonitor;
  cycle();
  EXPECT_EQ(session_.phase(), FriPhase::kMonitoring);
  EXPECT_LT(sentFrom(kHome), 1e-6);
  datagram_.to_host.integers[1] = 0;
  EXPECT_TRUE(cycle(kHome)) << "from rest it may begin again";
}

TEST_F(FriSessionTest, FallsAreAnsweredUntilHaltIsCalled) {
  commanding();
  datagram_.quality = FriQuality::kBad;
  cycle(moving(1));
  expectFallen(FriFall::kPoorQuality, LinkFault::kPoorLine);
  datagram_.quality = FriQuality::kPerfect;
  datagram_.state = FriState::kMonitor;
  cycle();
  EXPECT_EQ(session_.fault(), LinkFault::kPoorLine);
  session_.halt();
  cycle();
  EXPECT_EQ(session_.fault(), LinkFault::kNone);
  commanding();
}

TEST_F(FriSessionTest, TellsWhyItFell) {
  commanding();
  datagram_.drive_errors = 4;
  cycle(moving(1));
  EXPECT_EQ(session_.fall(), FriFall::kDriveError);
  session_.halt();
  EXPECT_EQ(session_.fault(), LinkFault::kDriveFault) << "while the error lasts";
  datagram_.drive_errors = 0;
  datagram_.state = FriState::kMonitor;
  cycle();
  commanding();
  datagram_.state = FriState::kMonitor;
  cycle(moving(1));
  expectFallen(FriFall::kLeftCommand, LinkFault::kNotReady);
}

TEST_F(FriSessionTest, WrongCommandsAreNotSent) {
  const auto refused = [this](const Joints& wish) {
    session_.halt();
    datagram_.state = FriState::kMonitor;
    cycle();
    commanding();
    EXPECT_EQ(cycle(wish).error(), LinkFault::kDriveFault);
    EXPECT_LT(sentFrom(kHome), 1e-6);
    expectFallen(FriFall::kWrongCommand, LinkFault::kDriveFault);
  };
  refused(kHome + Joints::Constant(7, 0.01));
  refused(Joints::Constant(7, std::numeric_limits<double>::quiet_NaN()));
  refused(Joints::Zero(6));
  compliance_.joint_damping = std::numeric_limits<double>::infinity();
  session_.halt();
  datagram_.state = FriState::kMonitor;
  cycle();
  EXPECT_EQ(cycle(kHome).error(), LinkFault::kDriveFault);
}

TEST_F(FriSessionTest, SequencesWrapAndOneLostDatagramIsBridged) {
  datagram_.sequence = 65'500;
  commanding();
  for (int i = 1; i <= 50; ++i) ASSERT_TRUE(cycle(moving(i)));
  EXPECT_EQ(session_.counts().lost, 0u);
  ++datagram_.sequence;
  ASSERT_TRUE(cycle(moving(51)));
  EXPECT_EQ(session_.counts().lost, 1u);
  EXPECT_NEAR(session_.elapsed_s(), 0.002, 1e-8);
  datagram_.sequence = static_cast<std::uint16_t>(datagram_.sequence + 2);
  cycle(moving(52));
  expectFallen(FriFall::kLostDatagrams, LinkFault::kPoorLine);
}

TEST_F(FriSessionTest, DoubledAndOldDatagramsAreOnlyCounted) {
  commanding();
  EXPECT_FALSE(session_.take(datagram_));
  auto old = datagram_;
  old.sequence = static_cast<std::uint16_t>(old.sequence - 3);
  old.q_rad.fill(9.0F);
  EXPECT_FALSE(session_.take(old));
  EXPECT_EQ(session_.newest().sequence, datagram_.sequence);
  EXPECT_EQ(session_.counts().duplicated, 1u);
  EXPECT_EQ(session_.counts().reordered, 1u);
  EXPECT_TRUE(cycle(moving(1)));
}

TEST_F(FriSessionTest, AJumpOfTheArmIsNotBelievedAtOnce) {
  commanding();
  auto damaged = datagram_;
  ++damaged.sequence;
  damaged.q_rad[2] += 0.5F;
  EXPECT_FALSE(session_.take(damaged));
  EXPECT_EQ(session_.counts().implausible, 1u);
  ++datagram_.sequence;
  EXPECT_TRUE(cycle(moving(1))) << "one is bridged";
  damaged.sequence = datagram_.sequence;
  for (int i = 0; i < 10; ++i) {
    ++damaged.sequence;
    session_.take(damaged);
  }
  answer_ = session_.answer();
  datagram_ = damaged;
  expectFallen(FriFall::kLostDatagrams, LinkFault::kPoorLine);
}

TEST_F(FriSessionTest, ASequenceThatBeginsAnewEndsTheMotion) {
  datagram_.sequence = 1000;
  commanding();
  datagram_.sequence = 1;
  for (int i = 0; i < 9; ++i) EXPECT_FALSE(session_.take(datagram_));
  cycle();
  expectFallen(FriFall::kLostDatagrams, LinkFault::kPoorLine);
}

TEST_F(FriSessionTest, SilenceEndsTheMotionAlsoWhenItIsOver) {
  commanding();
  session_.silence();
  EXPECT_EQ(session_.fault(), LinkFault::kNoAnswer);
  datagram_.sequence = 7;
  cycle();
  expectFallen(FriFall::kSilence, LinkFault::kNoAnswer);
  session_.halt();
  EXPECT_EQ(session_.phase(), FriPhase::kStopping);
}

TEST_F(FriSessionTest, BendsTheSpringsAsToldWithinTheControllersRanges) {
  FriSession session({.gives_way = robot::GivesWay::kInJoints});
  datagram_.control = FriControl::kJointImpedance;
  const auto turn = [&](const robot::Compliance& compliance) {
    ++datagram_.sequence;
    session.take(datagram_);
    EXPECT_TRUE(session.command({kHome, compliance}));
    return session.answer();
  };
  robot::Compliance soft;
  soft.joint_stiffness_nm_rad = Joints::Constant(7, 150.0);
  soft.joint_stiffness_nm_rad[6] = 1e6;
  auto sent = turn({});
  EXPECT_EQ(sent.flags, kFriJointPosition | kFriJointStiffness | kFriJointDamping);
  EXPECT_EQ(sent.from_host.integers[0], 30);
  EXPECT_EQ(sent.joint_stiffness_nm_rad[0], 1000.0F);
  datagram_.state = FriState::kCommand;
  for (int i = 0; i < 20; ++i) sent = turn(soft);
  EXPECT_EQ(sent.flags, kFriJointPosition | kFriJointStiffness | kFriJointDamping);
  EXPECT_EQ(sent.joint_stiffness_nm_rad[0], 150.0F);
  EXPECT_EQ(sent.joint_stiffness_nm_rad[6], 2000.0F);
  EXPECT_EQ(sent.joint_damping[3], 0.7F);
}

TEST_F(FriSessionTest, GivesAPoseAlongWhereTheArmGivesWayAtTheTool) {
  const auto arm = robot::readUrdf(std::filesystem::path(RESOURCES) / "robots/lbr4plus.urdf");
  ASSERT_TRUE(arm) << describe(arm.error());
  const robot::Kinematics kinematics(*arm);
  FriSettings settings;
  settings.gives_way = robot::GivesWay::kAtTool;
  settings.arm = *arm;
  FriSession session(settings);
  const RigidTransform X_FT = makeTransform(Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0), {0.01, 0.02, 0.2});
  const auto wireOf = [&](const Joints& q) {
    std::array<float, 12> wire{};
    const RigidTransform X_BT = kinematics.flange(q) * X_FT;
    for (int i = 0; i < 12; ++i) wire[static_cast<std::size_t>(i)] = static_cast<float>(X_BT(i / 4, i % 4));
    return wire;
  };
  const auto expectPose = [](const std::array<float, 12>& sent, const std::array<float, 12>& wanted) {
    for (std::size_t i = 0; i < sent.size(); ++i) EXPECT_NEAR(sent[i], wanted[i], 1e-6) << i;
  };
  datagram_.control = FriControl::kCartesianImpedance;
  datagram_.flange = wireOf(kHome);
  FriCommand sent;
  for (int i = 0; i < 20; ++i) {
    datagram_.state = i < 3 ? FriState::kMonitor : FriState::kCommand;
    ++datagram_.sequence;
    session.take(datagram_);
    ASSERT_TRUE(session.command({kHome, {}}));
    sent = session.answer();
    expectPose(sent.flange, datagram_.flange);
  }
  EXPECT_EQ(sent.flags, kFriJointPosition | kFriToolPosition | kFriToolStiffness | kFriToolDamping);
  EXPECT_EQ(sent.from_host.integers[0], 20);
  EXPECT_EQ(sent.tool_stiffness[3], 200.0F);
  ++datagram_.sequence;
  session.take(datagram_);
  ASSERT_TRUE(session.command({moving(3), {}}));
  expectPose(session.answer().flange, wireOf(moving(3)));
}

TEST_F(FriSessionTest, TakesNothingFromTheHeap) {
  if (!testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  commanding();
  const auto wish = moving(1);
  EXPECT_EQ(testing::heapCallsIn([&] {
              for (int i = 0; i < 10; ++i) {
                ++datagram_.sequence;
                static_cast<void>(session_.take(datagram_));
                static_cast<void>(session_.command({wish, compliance_}));
                answer_ = session_.answer();
              }
              session_.halt();
            }),
            0u);
}

}  // namespace
}  // namespace mirrorarm::devices
