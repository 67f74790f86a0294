#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/devices/fri_datagram.h"

namespace mirrorarm::devices {
namespace {

using Bytes = std::vector<std::byte>;

template <class Message, std::size_t kSize>
Bytes bytesOf(const Message& message) {
  Bytes bytes(kSize);
  encode(message, std::span<std::byte, kSize>(bytes));
  return bytes;
}

FriMeasurement measurement() {
  FriMeasurement m;
  m.sequence = 0xFFFF;
  m.reflected = 0x1234;
  m.to_host.integers[1] = -7;
  m.to_host.reals[15] = 2.5F;
  m.to_host.booleans = 0x8001;
  m.timestamp_s = 12.5F;
  m.state = FriState::kCommand;
  m.quality = FriQuality::kPerfect;
  m.measurement_period_s = m.command_period_s = 0.001F;
  m.safety_factor = 0.8F;
  m.answers = {0.99F, 1e-3F, 2e-4F, 0.01F, 70000};
  m.drives_on = 0x7F;
  m.control = FriControl::kJointImpedance;
  m.drive_errors = 0x10;
  for (std::size_t i = 0; i < kFriJoints; ++i) {
    const auto x = static_cast<float>(i);
    m.q_rad[i] = 0.1F * x;
    m.commanded_q_rad[i] = 1.0F + 0.5F * x;
    m.commanded_q_offset_rad[i] = 0.01F * x;
    m.external_torque_nm[i] = -x;
    m.gravity_nm[i] = 10.0F * x;
  }
  m.jacobian[41] = 41.0F;
  return m;
}

FriCommand command() {
  FriCommand c;
  c.sequence = 3;
  c.reflected = 0xFFFE;
  c.from_host.integers[1] = 1;
  c.flags = kFriJointPosition | kFriJointStiffness;
  c.q_rad = {0, 1, 2, 3, 4, 5, 6};
  c.joint_stiffness_nm_rad.fill(1000.0F);
  c.tool_damping[5] = 0.7F;
  return c;
}

const auto kMeasured = [] { return bytesOf<FriMeasurement, kFriMeasurementSize>(measurement()); };
const auto kCommanded = [] { return bytesOf<FriCommand, kFriCommandSize>(command()); };

template <class Number>
Number at(const Bytes& bytes, std::size_t offset) {
  Number value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

void put(Bytes& bytes, std::size_t offset, float value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

TEST(FriDatagram, MeasurementLiesOnTheWireAsTheTableSays) {
  const Bytes bytes = kMeasured();
  EXPECT_EQ(at<std::uint16_t>(bytes, 0), 0xFFFF);
  EXPECT_EQ(at<std::uint16_t>(bytes, 4), 916);
  EXPECT_EQ(at<std::uint16_t>(bytes, 6), 0x2006);
  EXPECT_EQ(at<float>(bytes, 68), 2.5F);
  EXPECT_EQ(at<std::int32_t>(bytes, 76), -7);
  EXPECT_EQ(at<std::uint16_t>(bytes, 136), 0x8001);
  EXPECT_EQ(at<float>(bytes, 140), 12.5F);
  EXPECT_EQ(at<std::uint16_t>(bytes, 144), 2);
  EXPECT_EQ(at<std::uint16_t>(bytes, 146), 3);
  EXPECT_EQ(at<float>(bytes, 156), 0.8F);
  EXPECT_EQ(at<std::uint32_t>(bytes, 176), 70000u);
  EXPECT_EQ(at<std::uint16_t>(bytes, 180), 0x7F);
  EXPECT_EQ(at<std::uint16_t>(bytes, 182), 3);
  EXPECT_EQ(at<std::uint16_t>(bytes, 184), 0x10);
  EXPECT_EQ(at<float>(bytes, 216 + 24), 0.6F);
  EXPECT_EQ(at<float>(bytes, 292), 1.0F);
  EXPECT_EQ(at<float>(bytes, 320 + 4), 0.01F);
  EXPECT_EQ(at<float>(bytes, 472 + 24), -6.0F);
  EXPECT_EQ(at<float>(bytes, 524 + 164), 41.0F);
  EXPECT_EQ(at<float>(bytes, 888 + 24), 60.0F);
}

TEST(FriDatagram, CommandLiesOnTheWireAsTheTableSays) {
  const Bytes bytes = kCommanded();
  EXPECT_EQ(at<std::uint16_t>(bytes, 2), 0xFFFE);
  EXPECT_EQ(at<std::uint16_t>(bytes, 4), 376);
  EXPECT_EQ(at<std::uint16_t>(bytes, 6), 0x1005);
  EXPECT_EQ(at<std::int32_t>(bytes, 76), 1);
  EXPECT_EQ(at<std::uint32_t>(bytes, 140), 0x11u);
  EXPECT_EQ(at<float>(bytes, 144 + 24), 6.0F);
  EXPECT_EQ(at<float>(bytes, 272), 1000.0F);
  EXPECT_EQ(at<float>(bytes, 372), 0.7F);
}

TEST(FriDatagram, ReadsBackWhatItWrote) {
  const auto m = friMeasurementOf(kMeasured());
  ASSERT_TRUE(m);
  EXPECT_EQ((bytesOf<FriMeasurement, kFriMeasurementSize>(*m)), kMeasured());
  const auto c = friCommandOf(kCommanded());
  ASSERT_TRUE(c);
  EXPECT_EQ((bytesOf<FriCommand, kFriCommandSize>(*c)), kCommanded());
}

TEST(FriDatagram, RefusesWithTheReason) {
  const auto refusal = [](auto change) {
    Bytes bytes = kMeasured();
    change(bytes);
    const auto read = friMeasurementOf(bytes);
    return read ? std::string_view("none") : id(read.error());
  };
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal([](Bytes& b) { b.pop_back(); }), "short");
  EXPECT_EQ(refusal([](Bytes& b) { b.clear(); }), "short");
  EXPECT_EQ(refusal([](Bytes& b) { b.push_back(std::byte{0}); }), "long");
  EXPECT_EQ(refusal([](Bytes& b) { b[6] = std::byte{5}; }), "wrong_id");
  EXPECT_EQ(refusal([](Bytes& b) { b[4] = std::byte{0}; }), "wrong_size");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 216, nan); }), "not_finite");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 244, nan); }), "not_finite") << "the pose is mirrored";
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 320, inf); }), "not_finite");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 472, nan); }), "not_finite");
  EXPECT_EQ(refusal([](Bytes& b) { b[144] = std::byte{3}; }), "out_of_range");
  EXPECT_EQ(refusal([](Bytes& b) { b[146] = std::byte{4}; }), "out_of_range");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 148, nan); }), "out_of_range");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 148, 1.0F); }), "out_of_range");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 216, 7.0F); }), "out_of_range");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 472, -2000.0F); }), "out_of_range");
  EXPECT_EQ(refusal([&](Bytes& b) { put(b, 888, nan); }), "none") << "gravity is not used";
}

TEST(FriDatagram, CommandsNeedFiniteValuesOnlyWhereFlagged) {
  Bytes bytes = kCommanded();
  put(bytes, 328, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(friCommandOf(bytes));
  put(bytes, 144, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(friCommandOf(bytes).error(), FriRefusal::kNotFinite);
}

template <class Read>
void shake(const Bytes& whole, Read read) {
  std::mt19937 random(3);
  for (int round = 0; round < 20'000; ++round) {
    Bytes bytes = whole;
    for (unsigned i = 0; i < 1 + random() % 8; ++i)
      bytes[random() % bytes.size()] ^= static_cast<std::byte>(1u << random() % 8);
    if (round % 7 == 0) bytes.resize(random() % (bytes.size() + 8));
    read(bytes);
  }
  for (int round = 0; round < 2000; ++round) {
    Bytes bytes(random() % 1200);
    for (auto& byte : bytes) byte = static_cast<std::byte>(random());
    read(bytes);
  }
}

TEST(FriDatagram, AnyBytesAreAValueOrARefusal) {
  shake(kMeasured(), [](const Bytes& bytes) {
    if (const auto m = friMeasurementOf(bytes)) {
      for (const float q : m->q_rad) ASSERT_TRUE(std::isfinite(q));
    }
  });
  shake(kCommanded(), [](const Bytes& bytes) {
    if (const auto c = friCommandOf(bytes); c && (c->flags & kFriJointPosition) != 0) {
      for (const float q : c->q_rad) ASSERT_TRUE(std::isfinite(q));
    }
  });
}

}  // namespace
}  // namespace mirrorarm::devices
