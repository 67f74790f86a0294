#include <memory>

#include <gtest/gtest.h>

#include "core/devices/fri_joints.h"
#include "core/devices/fri_session.h"
#include "core/devices/joint_speed.h"
#include "core/peers/faulty_wire.h"
#include "core/peers/fri_controller_host.h"
#include "tests/peers/fri_driver.h"

namespace mirrorarm::peers {
namespace {

using devices::FriFall;
using robot::Joints;
using robot::LinkFault;

/// FriLink and FriControllerHost without sockets and clocks: each cycle in step, the same every time.
class LockstepLink final : public robot::RobotLink {
 public:
  LockstepLink(const std::vector<FriFault>& faults, const FriControllerSettings& settings,
               const devices::FriSettings& session)
      : controller(lbr(), kHome, settings),
        faults_(faults),
        session_(session),
        there_(faults, false, 1),
        back_(faults, true, 2) {}

  /// The controller's next datagram comes, or not.
  void beginCycle() {
    time_ += toClock(Seconds(0.001));
    fresh_ = false;
    applyFaults(faults_, seconds(), controller);
    devices::FriMeasurement measurement = controller.cycle(time_);
    std::vector<std::byte> bytes(devices::kFriMeasurementSize);
    encode(measurement, std::span<std::byte, devices::kFriMeasurementSize>(bytes));
    there_.put(bytes, seconds());
    for (const Datagram& each : there_.take()) {
      const auto read = devices::friMeasurementOf(each);
      if (!read) ++refused;
      if (!read || !session_.take(*read)) continue;
      fresh_ = true;
      if (session_.elapsed_s() == 0.0) speed_.reset();
      speed_.add(devices::jointsOf(read->q_rad), session_.elapsed_s());
    }
    quiet_cycles_ = fresh_ ? 0 : quiet_cycles_ + 1;
    if (quiet_cycles_ == 50) session_.silence();
  }
  void endCycle() {
    if (fresh_) {
      std::vector<std::byte> bytes(devices::kFriCommandSize);
      encode(session_.answer(), std::span<std::byte, devices::kFriCommandSize>(bytes));
      back_.put(bytes, seconds());
      for (const Datagram& each : back_.take()) controller.answer(each, time_);
    }
    there_.endCycle();
    back_.endCycle();
  }

  Expected<robot::RobotState, LinkFault> read() noexcept override {
    if (!fresh_) return unexpected(LinkFault::kNoAnswer);
    if (session_.fault() != LinkFault::kNone) return unexpected(session_.fault());
    return robot::RobotState{devices::jointsOf(session_.newest().q_rad), speed_.value(), {}, time_};
  }
  Expected<void, LinkFault> command(const robot::RobotCommand& command) noexcept override {
    if (!fresh_) return unexpected(LinkFault::kNoAnswer);
    return session_.command(command);
  }
  void halt() noexcept override { session_.halt(); }
  Seconds period() const noexcept override { return Seconds(0.001); }
  double seconds() const { return Seconds(time_.time_since_epoch()).count(); }
  const devices::FriSession& session() const { return session_; }

  FriController controller;
  int refused = 0;

 private:
  std::vector<FriFault> faults_;
  devices::FriSession session_;
  devices::JointSpeed speed_;
  FaultyWire there_, back_;
  TimePoint time_{};
  bool fresh_ = false;
  int quiet_cycles_ = 0;
};

/// A session of some seconds with a fault or none.
struct Ride {
  explicit Ride(const std::string& fault, const FriControllerSettings& settings = {},
                const devices::FriSettings& session = {})
      : link(fault.empty() ? std::vector<FriFault>{} : std::vector{friFaultOf(fault).value()}, settings,
             session),
        driver(link) {}

  void run(double seconds) {
    Joints last_v = link.controller.v();
    for (const double end = link.seconds() + seconds; link.seconds() < end;) {
      link.beginCycle();
      driver.cycle();
      link.endCycle();
      const Joints v = link.controller.v();
      fastest = std::max(fastest, v.cwiseAbs().maxCoeff());
      hardest = std::max(hardest, (v - last_v).cwiseAbs().maxCoeff() / 0.001);
      last_v = v;
    }
  }
  bool isAtRest() const { return link.controller.v().cwiseAbs().maxCoeff() < 1e-4; }

  LockstepLink link;
  FriDriver driver;
  double fastest = 0.0, hardest = 0.0;
};

TEST(FriPair, StartsMovesAndNeverMissesTheMirror) {
  Ride ride("");
  ride.run(1.5);
  EXPECT_EQ(ride.driver.fault(), LinkFault::kNone);
  EXPECT_EQ(ride.link.controller.state(), devices::FriState::kCommand);
  EXPECT_EQ(ride.link.controller.report().starts, 1u);
  EXPECT_GT(ride.fastest, 0.1);
  EXPECT_EQ(ride.link.controller.report().mirror_errors, 0u);
  EXPECT_EQ(ride.link.controller.report().missed, 0u);
  EXPECT_TRUE(ride.link.controller.report().falls.empty());
}

TEST(FriPair, GoesThroughTheWrapOfTheSequences) {
  Ride ride("");
  ride.run(66.0);
  EXPECT_EQ(ride.driver.fault(), LinkFault::kNone);
  EXPECT_EQ(ride.link.session().counts().lost, 0u);
  EXPECT_EQ(ride.link.controller.report().missed, 0u);
  EXPECT_LT((ride.link.controller.q() - kHome).maxCoeff(), 0.32);
  EXPECT_GT((ride.link.controller.q() - kHome).maxCoeff(), 0.31);
}

TEST(FriPair, HaltEndsInMonitoringAndTheNextStartIsFromRest) {
  Ride ride("");
  ride.run(1.5);
  ASSERT_TRUE(ride.driver.isSwinging());
  ride.driver.stop();
  ride.run(0.02);
  EXPECT_EQ(ride.link.controller.report().falls.at(0).why, FriControllerFall::kStopped);
  EXPECT_LT(ride.hardest, 7.0) << "drives brake at 6 rad/s^2";
}

struct Case {
  const char* fault;
  LinkFault expected;  ///< kNone: it goes on
  FriFall fall;
};

class FriFaults : public ::testing::TestWithParam<Case> {};

TEST_P(FriFaults, EndInRestAndAReasonOrAreBridged) {
  Ride ride(GetParam().fault);
  ride.run(3.0);
  EXPECT_EQ(ride.driver.fault(), GetParam().expected) << robot::id(ride.driver.fault());
  EXPECT_EQ(ride.link.session().fall(), GetParam().fall) << devices::id(ride.link.session().fall());
  if (GetParam().expected == LinkFault::kNone) {
    EXPECT_EQ(ride.link.controller.state(), devices::FriState::kCommand);
    return;
  }
  EXPECT_TRUE(ride.isAtRest());
  EXPECT_EQ(ride.link.controller.state(), devices::FriState::kMonitor);
  const Joints rest = ride.link.controller.q();
  ride.run(0.5);
  EXPECT_LT((ride.link.controller.q() - rest).cwiseAbs().maxCoeff(), 1e-6) << "nothing resumes by itself";
  EXPECT_LE(ride.fastest, 0.25);
  EXPECT_LE(ride.hardest, 21.0) << "no jerk beyond what the motors can";
}

INSTANTIATE_TEST_SUITE_P(
    Each, FriFaults,
    ::testing::Values(Case{"lost@1.2+0.001", LinkFault::kNone, FriFall::kNone},
                      Case{"lost:0.005@1.2", LinkFault::kNone, FriFall::kNone},
                      Case{"lost@1.2+0.003", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"lost:0.3@1.2", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"silence@1.2+0.2", LinkFault::kNoAnswer, FriFall::kSilence},
                      Case{"silence@1.2+5", LinkFault::kNoAnswer, FriFall::kSilence},
                      Case{"duplicated@1.2", LinkFault::kNone, FriFall::kNone},
                      Case{"reordered:0.01@1.2", LinkFault::kNone, FriFall::kNone},
                      Case{"late:0.01@1.2", LinkFault::kNone, FriFall::kNone},
                      Case{"late@1.2", LinkFault::kNotReady, FriFall::kLeftCommand},
                      Case{"short@1.2+0.01", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"long@1.2+0.01", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"wrong_id@1.2+0.01", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"nan@1.2+0.01", LinkFault::kPoorLine, FriFall::kLostDatagrams},
                      Case{"nan@1.2+0.001", LinkFault::kNone, FriFall::kNone},
                      Case{"drive_error@1.2+0.5", LinkFault::kDriveFault, FriFall::kDriveError},
                      Case{"poor_quality@1.2+0.5", LinkFault::kPoorLine, FriFall::kPoorQuality},
                      Case{"start_pose", LinkFault::kDriveFault, FriFall::kStartPose},
                      Case{"answer-lost@1.2+0.003", LinkFault::kNotReady, FriFall::kLeftCommand},
                      Case{"answer-nan@1.2+0.003", LinkFault::kNotReady, FriFall::kLeftCommand},
                      Case{"answer-wrong_id@1.2+0.003", LinkFault::kNotReady, FriFall::kLeftCommand},
                      Case{"answer-short@1.2+0.003", LinkFault::kNotReady, FriFall::kLeftCommand},
                      Case{"answer-duplicated@1.2", LinkFault::kNone, FriFall::kNone}),
    [](const auto& each) {
      std::string name = each.param.fault;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

TEST(FriPair, AFallIsMendedByAResetFromRest) {
  Ride ride("silence@1.2+0.2");
  ride.run(2.0);
  ASSERT_EQ(ride.driver.fault(), LinkFault::kNoAnswer);
  ride.driver.reset();
  ride.run(1.5);
  EXPECT_EQ(ride.driver.fault(), LinkFault::kNone) << robot::id(ride.driver.fault());
  EXPECT_TRUE(ride.driver.isSwinging());
  EXPECT_EQ(ride.link.controller.report().starts, 2u);
}

TEST(FriPair, GarbledDatagramsNeverMakeTheArmJump) {
  for (const auto* fault : {"garbled:0.02@1", "answer-garbled:0.02@1"}) {
    Ride ride(fault);
    ride.run(3.0);
    EXPECT_LE(ride.fastest, 0.35) << fault;
    EXPECT_LE(ride.hardest, 21.0) << fault;
  }
}

TEST(FriPair, AnyFaultsTogetherEndInRestOrGoOn) {
  std::vector<FriFault> faults;
  for (const auto* text : {"lost:0.02@0.8", "late:0.02@0.8", "duplicated:0.1", "reordered:0.02@0.8",
                           "nan:0.01@1", "answer-late:0.02@1", "answer-reordered:0.02@1"})
    faults.push_back(friFaultOf(text).value());
  LockstepLink link(faults, {}, {});
  FriDriver driver(link);
  for (int i = 0; i < 6000; ++i) {
    link.beginCycle();
    driver.cycle();
    link.endCycle();
    ASSERT_LE(link.controller.v().cwiseAbs().maxCoeff(), 0.25);
    if (i % 1500 == 1499) driver.reset();
  }
}

TEST(FriController, RefusesToStartAHostThatDoesNotMirror) {
  FriController controller(lbr(), kHome, {});
  devices::FriCommand answer;
  for (int i = 0; i < 1000; ++i) {
    const auto& measurement = controller.cycle(TimePoint(std::chrono::milliseconds(i)));
    answer.sequence = static_cast<std::uint16_t>(i);
    answer.reflected = measurement.sequence;
    answer.flags = devices::kFriJointPosition;
    answer.q_rad = measurement.q_rad;
    answer.q_rad[2] += 0.01F;
    answer.from_host.integers[1] = 1;
    std::array<std::byte, devices::kFriCommandSize> bytes;
    encode(answer, bytes);
    controller.answer(bytes, TimePoint(std::chrono::milliseconds(i)));
  }
  EXPECT_EQ(controller.state(), devices::FriState::kMonitor);
  ASSERT_EQ(controller.report().falls.size(), 1u) << "once a request";
  EXPECT_EQ(controller.report().falls[0].why, FriControllerFall::kInterpolationError);
  EXPECT_GT(controller.report().mirror_errors, 900u);
}

/// What the controller does when its host's answers turn bad while it takes commands: `spoil` knows for how
/// many cycles.
template <class Spoil>
FriControllerFall fallBy(Spoil spoil) {
  FriController controller(lbr(), kHome, {});
  devices::FriSession session{devices::FriSettings{}};
  for (int i = 0; i < 2000 && controller.report().falls.empty(); ++i) {
    const TimePoint now{std::chrono::milliseconds(i)};
    session.take(controller.cycle(now));
    static_cast<void>(session.command({kHome, {}}));
    auto answer = session.answer();
    answer.from_host.integers[1] = i < 300 ? answer.from_host.integers[1] : 1;
    if (i > 500) spoil(answer, i - 500);
    std::array<std::byte, devices::kFriCommandSize> bytes;
    encode(answer, bytes);
    controller.answer(bytes, now);
  }
  return controller.report().falls.at(0).why;
}

TEST(FriController, FallsBackToMonitoring) {
  using devices::FriCommand;
  EXPECT_EQ(fallBy([](FriCommand& c, int) { c.q_rad[0] += 0.01F; }), FriControllerFall::kJump);
  EXPECT_EQ(fallBy([](FriCommand& c, int) { c.flags |= devices::kFriJointStiffness; }),
            FriControllerFall::kFlags);
  EXPECT_EQ(fallBy([](FriCommand& c, int) { c.reflected -= 1; }), FriControllerFall::kMissedAnswers);
  EXPECT_EQ(fallBy([](FriCommand& c, int) { c.from_host.integers[1] = 0; }), FriControllerFall::kStopped);
  EXPECT_EQ(
      fallBy([](FriCommand& c, int cycle) { c.q_rad[1] = static_cast<float>(kHome[1] + 0.0015 * cycle); }),
      FriControllerFall::kLimit);
}

}  // namespace
}  // namespace mirrorarm::peers
