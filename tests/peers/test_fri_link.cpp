#include <thread>

#include <gtest/gtest.h>

#include "core/devices/fri_link.h"
#include "core/peers/fri_controller_host.h"
#include "tests/common/no_heap.h"
#include "tests/peers/fri_driver.h"

namespace mirrorarm::peers {
namespace {

using devices::FriFall;
using devices::FriLink;
using devices::FriLinkSettings;
using devices::FriLinkStatistics;
using robot::LinkFault;

/// A link on a real socket. The controller's cycle is 4 ms and it bridges a second: a machine that pauses
/// must not fail a test.
std::unique_ptr<FriLink> openLink(const std::string& controller = "127.0.0.1") {
  FriLinkSettings settings;
  settings.port = 0;
  settings.controller = controller;
  settings.session.period = Seconds(0.004);
  settings.session.lost_in_a_row = 250;
  settings.session.silent_after = Seconds(0.5);
  settings.session.quality_to_start = devices::FriQuality::kOk;
  settings.session.quality_to_move = devices::FriQuality::kUnacceptable;
  auto link = FriLink::open(settings);
  EXPECT_TRUE(link) << link.error();
  return std::move(*link);
}

/// The controller in a thread of its own.
class RunningController {
 public:
  RunningController(std::uint16_t port, const std::vector<FriFault>& faults) {
    FriControllerHostSettings settings;
    settings.port = port;
    settings.faults = faults;
    settings.controller.period = Seconds(0.004);
    settings.controller.bridged_in_a_row = 250;
    settings.controller.perfect_share = 0.3;
    settings.controller.ok_share = 0.0;
    auto opened = FriControllerHost::open(settings, lbr(), kHome);
    EXPECT_TRUE(opened) << opened.error();
    host_ = std::move(*opened);
    thread_ = std::jthread([this](const std::stop_token& stop) { host_->run(stop, Seconds(30.0)); });
  }
  /// Ends it; then what it did may be looked at.
  const FriController& end() {
    thread_.request_stop();
    thread_.join();
    return host_->controller();
  }

 private:
  std::unique_ptr<FriControllerHost> host_;
  std::jthread thread_;
};

/// Drives until `done`, 10 s at most.
template <class Done>
FriLinkStatistics drive(FriLink& link, FriDriver& driver, Done done) {
  FriLinkStatistics seen;
  const TimePoint start = Clock::now();
  while (Clock::now() - start < std::chrono::seconds(10)) {
    link.awaitCycle(Seconds(0.05));
    driver.cycle();
    seen = link.takeStatistics().value_or(seen);
    if (done(seen)) break;
  }
  return seen;
}

TEST(FriLink, DrivesAnArmOverASocket) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {});
  const auto seen = drive(*link, driver, [&](const auto&) { return driver.isSwinging(); });
  EXPECT_TRUE(driver.isSwinging());
  EXPECT_EQ(driver.fault(), LinkFault::kNone) << robot::id(driver.fault());
  EXPECT_EQ(seen.phase, devices::FriPhase::kCommanding);
  EXPECT_EQ(seen.state, devices::FriState::kCommand);
  EXPECT_GT(seen.answered, 100u);
  EXPECT_GT(seen.round_trip.count(), 0.0);
  EXPECT_EQ(seen.refused, 0u);
  const auto& ended = controller.end();
  EXPECT_EQ(ended.report().mirror_errors, 0u);
  EXPECT_GT((ended.q() - kHome).norm(), 1e-4);
}

TEST(FriLink, SilenceEndsInAReason) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {*friFaultOf("silence@1")});
  const auto seen = drive(*link, driver, [](const auto& now) { return now.fall != FriFall::kNone; });
  EXPECT_EQ(seen.fall, FriFall::kSilence) << id(seen.fall);
  drive(*link, driver, [&](const auto&) { return driver.fault() != LinkFault::kNone; });
  EXPECT_EQ(driver.fault(), LinkFault::kNoAnswer);
}

TEST(FriLink, BeginsAnewForWhoHasStayedAway) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {});
  link->awaitCycle(Seconds(5.0));
  EXPECT_TRUE(link->read());
  std::this_thread::sleep_for(std::chrono::seconds(2));  // more than the socket has room for
  const auto seen = drive(*link, driver, [&](const auto&) { return driver.isSwinging(); });
  EXPECT_TRUE(driver.isSwinging());
  EXPECT_EQ(seen.fall, FriFall::kNone) << id(seen.fall);
  EXPECT_GT(seen.overtaken, 20u);
}

TEST(FriLink, ADriveErrorEndsInAReason) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {*friFaultOf("drive_error@1")});
  const auto seen = drive(*link, driver, [](const auto& now) { return now.fall != FriFall::kNone; });
  EXPECT_EQ(seen.fall, FriFall::kDriveError) << id(seen.fall);
  EXPECT_EQ(driver.fault(), LinkFault::kDriveFault);
}

TEST(FriLink, CountsWhatIsNoDatagramOfTheController) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {*friFaultOf("wrong_id:0.2"), *friFaultOf("long:0.2")});
  const auto seen = drive(*link, driver, [](const auto& now) { return now.refused > 20; });
  EXPECT_GT(seen.refused, 20u);
  EXPECT_TRUE(seen.last_refusal == devices::FriRefusal::kWrongId ||
              seen.last_refusal == devices::FriRefusal::kLong);
}

TEST(FriLink, AnswersOnlyItsController) {
  const auto link = openLink("127.0.0.2");
  FriDriver driver(*link);
  RunningController controller(link->port(), {});
  const auto seen = drive(*link, driver, [](const auto& now) { return now.foreign > 20; });
  EXPECT_GT(seen.foreign, 20u);
  EXPECT_EQ(seen.answered, 0u);
  EXPECT_EQ(controller.end().report().in_time, 0u);
}

TEST(FriLink, TakesNothingFromTheHeapInACycle) {
  if (!testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {*friFaultOf("garbled:0.02@1")});
  drive(*link, driver, [](const auto& now) { return now.phase == devices::FriPhase::kCommanding; });
  EXPECT_EQ(testing::heapCallsIn([&] {
              for (int i = 0; i < 200; ++i) {
                link->awaitCycle(Seconds(0.05));
                driver.cycle();
              }
              link->halt();
            }),
            0u);
}

TEST(FriLink, WhoeverLeavesBrakesTheArmAndStopsTheProgram) {
  const auto link = openLink();
  FriDriver driver(*link);
  RunningController controller(link->port(), {});
  drive(*link, driver, [&](const auto&) { return driver.isSwinging(); });
  ASSERT_TRUE(driver.isSwinging());
  robot::haltToRest(*link);
  const auto& ended = controller.end();
  ASSERT_EQ(ended.report().falls.size(), 1u);
  EXPECT_EQ(ended.report().falls.front().why, FriControllerFall::kStopped)
      << id(ended.report().falls.front().why);
}

TEST(FriLink, NothingButTheControllerMakesACycle) {
  const auto link = openLink("127.0.0.1");
  auto stranger = devices::UdpSocket::open("127.0.0.1", 0);
  ASSERT_TRUE(stranger) << stranger.error();
  std::jthread noise([&](const std::stop_token& stop) {
    const std::array<std::byte, 64> nonsense{};
    while (!stop.stop_requested()) {
      stranger->send(nonsense, {0x7F000001, link->port()});
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  });
  const TimePoint start = Clock::now();
  for (int i = 0; i < 5; ++i) link->awaitCycle(Seconds(0.02));
  EXPECT_GE(Seconds(Clock::now() - start), Seconds(0.1));
  EXPECT_GT(link->takeStatistics()->refused, 0u);
}

TEST(FriLink, SaysWhyAnAddressCannotBeHad) {
  FriLinkSettings settings;
  settings.address = "192.0.2.1";
  const auto elsewhere = FriLink::open(settings);
  ASSERT_FALSE(elsewhere);
  EXPECT_NE(elsewhere.error().find("192.0.2.1:49938"), std::string::npos);
  settings.controller = "not a host";
  EXPECT_FALSE(FriLink::open(settings));
}

}  // namespace
}  // namespace mirrorarm::peers
