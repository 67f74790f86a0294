#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "core/devices/igtl_message.h"
#include "core/devices/igtl_poses.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::devices {
namespace {

using Bytes = std::vector<std::byte>;

Bytes sample(const std::string& name) {
  const auto text = test::bytesOf(std::filesystem::path(SHARED_DATA) / "igtl-messages" / name);
  Bytes bytes;
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  return bytes;
}

#define SKIP_WITHOUT_SAMPLES() \
  if (!std::filesystem::exists(SHARED_DATA "/igtl-messages")) GTEST_SKIP() << "igtl-messages is absent"

/// What the protocol's own test data hold (igtl_test_data_transform.h).
RigidTransform samplePose() {
  Eigen::Matrix3d R;
  R << -0.954892, -0.196632, 0.222525, 0.196632, 0.142857, 0.970014, -0.222525, 0.970014, -0.0977491;
  return makeTransform(Eigen::Quaterniond(R), Eigen::Vector3d(0.0460531, 0.0194709, 0.0460531));
}

ReceivedPose pose() {
  return {"FlangeToTracker", 1790000000.25,
          makeTransform(Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), Eigen::Vector3d(0.1, -0.2, 0.3))};
}

TEST(Igtl, PosesOfTheProtocolsOwnSamples) {
  SKIP_WITHOUT_SAMPLES();
  for (const auto* name : {"test_transform_message.bin", "test_transform_message_Format2.bin"}) {
    IgtlStream stream;
    stream.add(sample(name));
    const auto message = stream.next();
    ASSERT_TRUE(message && *message) << name;
    EXPECT_EQ((*message)->type, "TRANSFORM");
    EXPECT_EQ((*message)->device, "DeviceName");
    const auto poses = posesOf(**message);
    ASSERT_EQ(poses.size(), 1u) << name;
    EXPECT_TRUE(poses[0].X.isApprox(samplePose(), 1e-5)) << poses[0].X.matrix();
  }
}

TEST(Igtl, EveryToolOfATrackingMessage) {
  SKIP_WITHOUT_SAMPLES();
  for (const auto* name : {"test_tdata_message.bin", "test_tdata_messageFormat2.bin"}) {
    IgtlStream stream;
    stream.add(sample(name));
    const auto message = stream.next();
    ASSERT_TRUE(message && *message) << name;
    const auto poses = posesOf(**message);
    ASSERT_EQ(poses.size(), 3u) << name;
    EXPECT_EQ(poses[0].name, "Tracker0");
    EXPECT_TRUE(poses[2].X.isApprox(samplePose(), 1e-5));
  }
}

TEST(Igtl, EverySampleIsReadOneAfterTheOtherByteByByte) {
  SKIP_WITHOUT_SAMPLES();
  IgtlStream stream;
  int messages = 0;
  for (const auto* name : {"test_status_message.bin", "test_transform_message.bin", "test_string_message.bin",
                           "test_position_message.bin", "test_image_message.bin", "test_sensor_message.bin",
                           "test_tdata_messageFormat2.bin"})
    for (const std::byte byte : sample(name)) {
      stream.add({&byte, 1});
      const auto message = stream.next();
      ASSERT_TRUE(message) << reason(message.error());
      messages += *message ? 1 : 0;
    }
  EXPECT_EQ(messages, 7);
}

TEST(Igtl, ReadsWhatItWrites) {
  IgtlStream stream;
  stream.add(igtlBytes(transformMessage(pose())));
  const auto message = stream.next();
  ASSERT_TRUE(message && *message);
  const auto poses = posesOf(**message);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].name, pose().name);
  EXPECT_NEAR(poses[0].time_s, pose().time_s, 1e-6);
  EXPECT_TRUE(poses[0].X.isApprox(pose().X, 1e-6));
}

TEST(Igtl, AFlippedBitIsNoticedAndEndsTheStream) {
  const auto whole = igtlBytes(transformMessage(pose()));
  for (std::size_t i = kIgtlHeaderSize; i < whole.size(); ++i) {
    auto broken = whole;
    broken[i] ^= std::byte{4};
    IgtlStream stream;
    stream.add(broken);
    ASSERT_FALSE(stream.next());
    stream.add(whole);
    EXPECT_FALSE(stream.next());  // out of step: nothing more is to be trusted
  }
}

TEST(Igtl, HugeBodiesAndMatricesThatAreNoneAreRefused) {
  auto huge = igtlBytes(transformMessage(pose()));
  huge[44] = std::byte{1};
  IgtlStream stream;
  stream.add(huge);
  const auto message = stream.next();
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error(), IgtlFault::kTooLarge);
  auto bent = pose();
  bent.X.linear() *= 1.1;
  EXPECT_TRUE(posesOf(transformMessage(bent)).empty());
  auto short_one = transformMessage(pose());
  short_one.content.resize(40);
  EXPECT_TRUE(posesOf(short_one).empty());
}

TEST(Igtl, AnyBytesDoNoHarm) {
  SKIP_WITHOUT_SAMPLES();
  std::mt19937 random(5);
  for (const auto* name :
       {"test_tdata_messageFormat2.bin", "test_transform_message_Format2.bin", "test_position_message.bin"}) {
    const auto whole = sample(name);
    for (int round = 0; round < 3000; ++round) {
      auto bytes = whole;
      for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<std::byte>(random());
      bytes.resize(random() % (bytes.size() + 1));
      IgtlStream stream;
      stream.add(bytes);
      if (const auto message = stream.next(); message && *message) static_cast<void>(posesOf(**message));
    }
  }
}

}  // namespace
}  // namespace mirrorarm::devices
