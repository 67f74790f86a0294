#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "core/devices/igtl_robot_host.h"
#include "core/devices/igtl_robot_link.h"
#include "tests/common/no_heap.h"

namespace mirrorarm::devices {
namespace {

using robot::Joints;
using robot::LinkFault;

constexpr int kJoints = 3;

robot::ArmDescription arm() {
  robot::ArmDescription arm;
  for (int i = 0; i < kJoints; ++i) arm.joints.push_back({"j", -1.0, 1.0, 1.0, 10.0, {}, {}});
  return arm;
}

/// Goes at once where it is told.
class IdealRobot final : public robot::RobotLink {
 public:
  Expected<robot::RobotState, LinkFault> read() noexcept override {
    if (fault != LinkFault::kNone) return unexpected(LinkFault{fault});
    return robot::RobotState{q, Joints::Zero(kJoints), Joints::Constant(kJoints, 2.0), Clock::now()};
  }
  Expected<void, LinkFault> command(const robot::RobotCommand& command) noexcept override {
    largest_step = std::max(largest_step.load(), (command.q_rad - q).cwiseAbs().maxCoeff());
    q = command.q_rad;
    halted = false;
    return {};
  }
  void halt() noexcept override { halted = true; }
  Seconds period() const noexcept override { return Seconds(0.001); }

  std::atomic<LinkFault> fault = LinkFault::kNone;
  std::atomic<bool> halted = false;
  std::atomic<double> largest_step = 0.0;
  Joints q = Joints::Zero(kJoints);  // the host's thread
};

/// A host in a thread of its own and a client of it.
class IgtlRobotTest : public ::testing::Test {
 protected:
  void lend(bool allow_motion = true, std::vector<std::string> allowed = {"127.0.0.1"}) {
    IgtlRobotHostSettings settings;
    settings.port = 0;
    settings.allow_motion = allow_motion;
    settings.allowed = std::move(allowed);
    settings.silent_after = Seconds(0.3);
    settings.oldest = Seconds(0.25);
    auto opened = IgtlRobotHost::open(settings, arm(), robot_);
    ASSERT_TRUE(opened) << opened.error();
    host_ = std::move(*opened);
    thread_ = std::jthread([this](const std::stop_token& stop) { host_->run(stop, Seconds(60.0)); });
  }
  std::unique_ptr<IgtlRobotLink> connect() {
    auto link = IgtlRobotLink::connect({"127.0.0.1", host_->port()}, Seconds(2.0));
    EXPECT_TRUE(link) << link.error();
    return link ? std::move(*link) : nullptr;
  }
  IgtlRobotHostReport end() {
    thread_.request_stop();
    thread_.join();
    return host_->report();
  }
  /// Walks joint 0 from `begin` at 0.1 rad/s; how far it came.
  static double walk(IgtlRobotLink& link, double begin, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      link.awaitCycle(Seconds(0.5));
      EXPECT_TRUE(link.read());
      Joints q = Joints::Zero(kJoints);
      q[0] = begin + 4e-4 * i;
      EXPECT_TRUE(link.command({q, {}}));
    }
    return begin + 4e-4 * (cycles - 1);
  }
  static void pass(IgtlRobotLink& link, int cycles) {
    for (int i = 0; i < cycles; ++i) link.awaitCycle(Seconds(0.5));
  }

  IdealRobot robot_;
  std::unique_ptr<IgtlRobotHost> host_;
  std::jthread thread_;
};

TEST_F(IgtlRobotTest, TellsStatesAndHeedsCommands) {
  lend();
  const auto link = connect();
  ASSERT_TRUE(link);
  EXPECT_EQ(link->jointCount(), kJoints);
  EXPECT_NEAR(link->period().count(), 0.004, 1e-12);
  const double end_rad = walk(*link, 0.0, 50);
  pass(*link, 3);
  const auto state = link->read();
  ASSERT_TRUE(state);
  EXPECT_NEAR(state->q_rad[0], end_rad, 1e-9);
  EXPECT_EQ(state->external_torque_nm[1], 2.0);
  link->halt();
  pass(*link, 5);
  EXPECT_TRUE(robot_.halted);
  EXPECT_GE(end().commands, 45u);
  EXPECT_LT(robot_.largest_step, 1.1e-3) << "on straight lines between the commands";
}

TEST_F(IgtlRobotTest, SilenceBrakesUntilTheClientHasAcknowledgedIt) {
  lend();
  const auto link = connect();
  const double end_rad = walk(*link, 0.0, 20);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  pass(*link, 2);
  EXPECT_TRUE(robot_.halted);
  EXPECT_EQ(link->read().error(), LinkFault::kPoorLine);
  EXPECT_EQ(link->command({Joints::Zero(kJoints), {}}).error(), LinkFault::kPoorLine);
  link->halt();
  pass(*link, 5);
  EXPECT_TRUE(link->read());
  walk(*link, end_rad, 20);
  EXPECT_EQ(end().stops, 1u);
}

TEST_F(IgtlRobotTest, AClientThatHangsUpLeavesAHaltedRobot) {
  lend();
  auto link = connect();
  walk(*link, 0.0, 20);
  link.reset();
  link = connect();
  ASSERT_TRUE(link);
  EXPECT_TRUE(robot_.halted);
  pass(*link, 1);
  EXPECT_EQ(link->read().error(), LinkFault::kPoorLine) << "the next client acknowledges it too";
}

TEST_F(IgtlRobotTest, AClosedLineKeepsTheBeat) {
  lend();
  const auto link = connect();
  ASSERT_TRUE(link);
  end();
  host_.reset();
  for (int i = 0; i < 100 && link->read(); ++i) link->awaitCycle(Seconds(0.02));
  const TimePoint start = Clock::now();
  for (int i = 0; i < 5; ++i) link->awaitCycle(Seconds(0.02));
  EXPECT_GE(Seconds(Clock::now() - start), Seconds(0.1));
  EXPECT_EQ(link->read().error(), LinkFault::kNoAnswer);
  EXPECT_EQ(link->command({Joints::Zero(kJoints), {}}).error(), LinkFault::kNoAnswer);
  robot::haltToRest(*link, Seconds(0.05));
}

TEST_F(IgtlRobotTest, MotionIsNeverAllowedOverTheWireAlone) {
  lend(false);
  const auto link = connect();
  pass(*link, 1);
  EXPECT_TRUE(link->read()) << "looking is free";
  EXPECT_EQ(link->command({Joints::Zero(kJoints), {}}).error(), LinkFault::kNotReady);
  auto other = TcpSocket::connect({"127.0.0.1", host_->port()}, Seconds(1.0));
  EXPECT_TRUE(other);
  EXPECT_EQ(end().commands, 0u);
}

TEST_F(IgtlRobotTest, OneClientAtATimeAndOnlyThoseOfTheList) {
  lend();
  const auto link = connect();
  EXPECT_FALSE(IgtlRobotLink::connect({"127.0.0.1", host_->port()}, Seconds(0.3)));
  EXPECT_EQ(end().turned_away, 1u);
  lend(true, {"127.0.0.9"});
  EXPECT_FALSE(IgtlRobotLink::connect({"127.0.0.1", host_->port()}, Seconds(0.3)));
  EXPECT_EQ(end().callers, 0u);
}

TEST_F(IgtlRobotTest, CommandsBeyondTheLimitsStopIt) {
  lend();
  const auto link = connect();
  walk(*link, 0.0, 20);
  link->awaitCycle(Seconds(0.5));
  EXPECT_TRUE(link->command({Joints::Constant(kJoints, 0.9), {}}));
  pass(*link, 5);
  EXPECT_EQ(link->read().error(), LinkFault::kDriveFault);
  EXPECT_TRUE(robot_.halted);
  EXPECT_EQ(link->command({Joints::Constant(kJoints, std::nan("")), {}}).error(), LinkFault::kDriveFault);
  EXPECT_EQ(end().refused[static_cast<std::size_t>(RobotRefusal::kBeyondLimits)], 1u);
}

TEST_F(IgtlRobotTest, AMotionThatBeginsElsewhereIsRefused) {
  lend();
  const auto link = connect();
  link->awaitCycle(Seconds(0.5));
  EXPECT_TRUE(link->command({Joints::Constant(kJoints, 0.1), {}}));
  pass(*link, 5);
  EXPECT_EQ(link->read().error(), LinkFault::kDriveFault);
  EXPECT_EQ(end().refused[static_cast<std::size_t>(RobotRefusal::kNotFromRest)], 1u);
}

TEST_F(IgtlRobotTest, AFaultOfTheRobotIsTold) {
  lend();
  const auto link = connect();
  walk(*link, 0.0, 20);
  robot_.fault = LinkFault::kDriveFault;
  pass(*link, 5);
  EXPECT_EQ(link->read().error(), LinkFault::kDriveFault);
  EXPECT_TRUE(robot_.halted);
  EXPECT_EQ(end().stops, 1u);
}

TEST_F(IgtlRobotTest, RefusesOldAndRepeatedCommands) {
  lend();
  auto socket = TcpSocket::connect({"127.0.0.1", host_->port()}, Seconds(1.0));
  ASSERT_TRUE(socket);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  RobotMessageBytes bytes;
  EXPECT_TRUE(socket->send(encode(RobotCommandMessage{1, 1, true, Joints::Zero(kJoints)}, bytes)));
  EXPECT_TRUE(socket->send(encode(RobotCommandMessage{0, 1, true, Joints::Zero(kJoints)}, bytes)));
  EXPECT_TRUE(socket->send(encode(RobotCommandMessage{9, 4'000'000, true, Joints::Zero(kJoints)}, bytes)));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const auto& report = end();
  EXPECT_EQ(report.refused[static_cast<std::size_t>(RobotRefusal::kTooOld)], 2u);
  EXPECT_EQ(report.refused[static_cast<std::size_t>(RobotRefusal::kOutOfOrder)], 1u);
  EXPECT_EQ(report.commands, 0u);
}

TEST_F(IgtlRobotTest, ACycleTakesNothingFromTheHeap) {
  if (!testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  lend();
  const auto link = connect();
  EXPECT_EQ(testing::heapCallsIn([&] { walk(*link, 0.0, 20); }), 0u);
}

RobotStateMessage aState() {
  return {7,
          3,
          LinkFault::kPoorLine,
          true,
          0.004,
          Joints::Constant(7, 0.5),
          Joints::Constant(7, -0.1),
          Joints::Constant(7, 3.0)};
}

TEST(IgtlRobotProtocol, ReadsBackWhatItWrote) {
  RobotMessageBytes bytes;
  const auto view = igtlView(encode(aState(), bytes));
  ASSERT_TRUE(view && *view);
  EXPECT_EQ((*view)->type, "SENSOR");
  const auto state = robotStateOf(**view);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->sequence, 7u);
  EXPECT_EQ(state->fault, LinkFault::kPoorLine);
  EXPECT_EQ(state->v_rad_s, aState().v_rad_s);
  EXPECT_EQ(state->external_torque_nm, aState().external_torque_nm);
  EXPECT_FALSE(robotCommandOf(**view));
  const auto command = igtlView(encode(RobotCommandMessage{5, 6, true, Joints::Constant(7, 1.5)}, bytes));
  EXPECT_EQ(robotCommandOf(**command)->q_rad[6], 1.5);
}

TEST(IgtlRobotProtocol, AnyBytesAreAMessageOrNone) {
  RobotMessageBytes bytes;
  const auto whole = igtlView(encode(aState(), bytes));
  std::mt19937 random(11);
  for (int round = 0; round < 20'000; ++round) {
    std::vector<std::byte> content((*whole)->content.begin(), (*whole)->content.end());
    for (unsigned i = 0; i < 1 + random() % 4; ++i)
      content[random() % content.size()] = static_cast<std::byte>(random());
    if (round % 5 == 0) content.resize(random() % (content.size() + 20));
    IgtlView view = **whole;
    view.content = content;
    if (const auto state = robotStateOf(view)) {
      ASSERT_LE(state->q_rad.size(), robot::kMaxJoints);
      ASSERT_TRUE(state->q_rad.allFinite());
      ASSERT_EQ(state->v_rad_s.size(), state->q_rad.size());
    }
    view.device = "RobotCommand";
    if (const auto command = robotCommandOf(view)) {
      ASSERT_TRUE(command->q_rad.allFinite());
    }
  }
}

}  // namespace
}  // namespace mirrorarm::devices
