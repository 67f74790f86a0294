#include <random>

#include <gtest/gtest.h>

#include "core/devices/igtl_poses.h"
#include "core/devices/igtl_tracking_host.h"

namespace mirrorarm::devices {
namespace {

TargetReport seenAt(double x_m, TargetSight sight = TargetSight::kTracked) {
  TargetReport report{"forearm", 1234.5, sight};
  report.X.translation() = Eigen::Vector3d(x_m, 0.0, 0.4);
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j) report.covariance(i, j) = 1e-8 * static_cast<double>(i + j + 1);
  return report;
}

std::vector<IgtlMessage> messagesOf(std::span<const std::byte> bytes) {
  IgtlStream stream;
  stream.add(bytes);
  std::vector<IgtlMessage> messages;
  for (;;) {
    const auto message = stream.next();
    EXPECT_TRUE(message);
    if (!message || !*message) return messages;
    messages.push_back(**message);
  }
}

TEST(TargetReport, GoesOverTheWireWithItsCovariance) {
  const auto report = seenAt(0.1, TargetSight::kPredicted);
  const auto messages = messagesOf(igtlBytes(report));
  ASSERT_EQ(messages.size(), 2u);
  const auto poses = posesOf(messages[0]);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].name, "forearm");
  EXPECT_TRUE(poses[0].X.isApprox(report.X, 1e-6));
  EXPECT_FALSE(targetReportOf(messages[0]));
  const auto read = targetReportOf(messages[1]);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, "forearm");
  EXPECT_EQ(read->sight, TargetSight::kPredicted);
  EXPECT_EQ(read->covariance, report.covariance);
  EXPECT_NEAR(read->time_s, 1234.5, 1e-6);
}

TEST(TargetReport, ALostTargetHasNoPose) {
  const auto messages = messagesOf(igtlBytes(seenAt(0.1, TargetSight::kLost)));
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_TRUE(posesOf(messages[0]).empty());
  EXPECT_EQ(targetReportOf(messages[0])->sight, TargetSight::kLost);
}

TEST(TargetReport, WhatIsNoneIsNotTakenForOne) {
  const auto good = messagesOf(igtlBytes(seenAt(0.1)))[1];
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    auto bad = good;
    bad.content[random() % bad.content.size()] = static_cast<std::byte>(random());
    if (random() % 2 == 0) bad.content.resize(random() % (bad.content.size() + 1));
    const auto read = targetReportOf(bad);
    EXPECT_TRUE(!read || read->covariance.allFinite());
  }
  auto robot = good;
  robot.content[0] = std::byte{3};
  EXPECT_FALSE(targetReportOf(robot));
}

class TrackingHostTest : public ::testing::Test {
 protected:
  void open(std::vector<std::string> allowed = {"127.0.0.1"}) {
    auto opened = IgtlTrackingHost::open({.port = 0, .allowed = std::move(allowed)});
    ASSERT_TRUE(opened) << opened.error();
    host_ = std::move(*opened);
  }
  TcpSocket call() {
    auto socket = TcpSocket::connect({"127.0.0.1", host_->port()}, Seconds(2.0));
    EXPECT_TRUE(socket) << socket.error();
    host_->greet();
    return std::move(*socket);
  }
  /// All that comes until nothing does; what is held up is sent meanwhile.
  std::vector<std::byte> drain(const TcpSocket& socket) {
    std::vector<std::byte> all;
    std::array<std::byte, 65536> piece{};
    while (socket.wait(Seconds(0.1))) {
      const auto size = socket.receive(piece);
      if (!size) break;
      all.insert(all.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(*size));
      host_->greet();
    }
    return all;
  }
  std::unique_ptr<IgtlTrackingHost> host_;
};

TEST_F(TrackingHostTest, TellsEveryClientEveryFrame) {
  open();
  const auto one = call(), other = call();
  EXPECT_EQ(host_->clients(), 2u);
  for (int i = 0; i < 5; ++i) host_->tell({seenAt(0.01 * i), seenAt(0.0, TargetSight::kLost)});
  for (const auto* client : {&one, &other}) EXPECT_EQ(messagesOf(drain(*client)).size(), 15u);
  EXPECT_EQ(host_->report().told, 10u);
  EXPECT_EQ(host_->report().dropped, 0u);
}

TEST_F(TrackingHostTest, ASlowClientMissesFramesAndThenGetsTheNewest) {
  open();
  const auto client = call();
  constexpr int kFrames = 100'000;
  for (int i = 1; i <= kFrames; ++i) host_->tell({seenAt(1e-6 * i)});
  EXPECT_TRUE(host_->isBehind());
  EXPECT_GT(host_->report().dropped, 0u);
  const auto messages = messagesOf(drain(client));
  ASSERT_GE(messages.size(), 2u);
  EXPECT_EQ(messages.size() % 2, 0u);
  EXPECT_NEAR(posesOf(messages[messages.size() - 2])[0].X.translation().x(), 1e-6 * kFrames, 1e-8);
  EXPECT_FALSE(host_->isBehind());
  EXPECT_EQ(host_->report().told + host_->report().dropped, std::uint64_t{kFrames});
}

TEST_F(TrackingHostTest, StrangersAreTurnedAway) {
  open({"127.0.0.2"});
  const auto stranger = call();
  EXPECT_EQ(host_->clients(), 0u);
  EXPECT_EQ(host_->report().turned_away, 1u);
  EXPECT_TRUE(drain(stranger).empty());
}

TEST_F(TrackingHostTest, WhoHangsUpIsLetGo) {
  open();
  {
    const auto client = call();
    EXPECT_EQ(host_->clients(), 1u);
  }
  for (int i = 0; i < 200 && host_->clients() > 0; ++i) host_->tell({seenAt(0.1)}), host_->greet();
  EXPECT_EQ(host_->clients(), 0u);
}

TEST_F(TrackingHostTest, ThereIsRoomForSoManyClients) {
  open();
  std::vector<TcpSocket> clients;
  for (std::size_t i = 0; i <= IgtlTrackingHost::kMostClients; ++i) clients.push_back(call());
  EXPECT_EQ(host_->clients(), IgtlTrackingHost::kMostClients);
  EXPECT_EQ(host_->report().turned_away, 1u);
}

}  // namespace
}  // namespace mirrorarm::devices
