#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/devices/pose_receiver.h"

namespace mirrorarm::devices {
namespace {

/// A tracker on the loopback that sends bytes to its first client and hangs up.
class FakeTracker {
 public:
  FakeTracker() : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
  }
  ~FakeTracker() {
    if (sender_.joinable()) sender_.join();
    ::close(listener_);
  }
  void send(std::vector<std::vector<std::byte>> pieces) {
    sender_ = std::thread([this, pieces = std::move(pieces)] {
      const int client = ::accept(listener_, nullptr, nullptr);
      for (const auto& piece : pieces) {
        EXPECT_EQ(::send(client, piece.data(), piece.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(piece.size()));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      ::close(client);
    });
  }
  std::uint16_t port = 0;

 private:
  int listener_;
  std::thread sender_;
};

std::vector<std::byte> messageAt(double x_m) {
  RigidTransform X = RigidTransform::Identity();
  X.translation().x() = x_m;
  return igtlBytes(transformMessage({"Tool", 1.0, X}));
}

/// Everything until the tracker hangs up, and its last word.
std::pair<std::vector<ReceivedPose>, std::string> everything(PoseReceiver& receiver) {
  std::vector<ReceivedPose> all;
  while (true) {
    const auto some = receiver.receive(Seconds(1.0));
    if (!some) return {all, some.error()};
    all.insert(all.end(), some->begin(), some->end());
  }
}

TEST(PoseReceiver, TakesPosesHoweverTheNetworkCutsThem) {
  FakeTracker tracker;
  auto joined = messageAt(0.1);
  const auto second = messageAt(0.2);
  joined.insert(joined.end(), second.begin(), second.end() - 30);
  tracker.send({joined, {second.end() - 30, second.end()}});
  auto receiver = PoseReceiver::connect({"127.0.0.1", tracker.port}, Seconds(1.0));
  ASSERT_TRUE(receiver) << receiver.error();
  const auto [poses, last_word] = everything(*receiver);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_NEAR(poses[1].X.translation().x(), 0.2, 1e-7);
  EXPECT_NE(last_word.find("closed"), std::string::npos);
}

TEST(PoseReceiver, SaysWhatIsWrong) {
  FakeTracker tracker;
  tracker.send({std::vector<std::byte>(100, std::byte{'G'})});
  auto receiver = PoseReceiver::connect({"127.0.0.1", tracker.port}, Seconds(1.0));
  ASSERT_TRUE(receiver);
  EXPECT_NE(everything(*receiver).second.find("no header"), std::string::npos);
  std::uint16_t gone = 0;
  {
    const FakeTracker closed;
    gone = closed.port;
  }
  const auto nobody = PoseReceiver::connect({"127.0.0.1", gone}, Seconds(0.5));
  ASSERT_FALSE(nobody);
  EXPECT_NE(nobody.error().find("127.0.0.1"), std::string::npos);
}

TEST(PoseReceiver, AddressesAreHostAndPort) {
  EXPECT_EQ(hostAddressOf("tracker.local", 18944)->port, 18944);
  EXPECT_EQ(hostAddressOf("10.0.0.5:2000", 18944)->port, 2000);
  EXPECT_EQ(hostAddressOf("10.0.0.5:2000", 18944)->host, "10.0.0.5");
  for (const auto* text : {"", ":80", "host:", "host:0", "host:70000", "host:a"})
    EXPECT_FALSE(hostAddressOf(text, 18944)) << text;
}

}  // namespace
}  // namespace mirrorarm::devices
