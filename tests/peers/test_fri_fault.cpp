#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/devices/fri_datagram.h"
#include "core/peers/faulty_wire.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::peers {
namespace {

TEST(FriFault, IsAWordWithAShareAndATime) {
  const auto fault = friFaultOf("answer-lost:0.25@5+2");
  ASSERT_TRUE(fault) << fault.error();
  EXPECT_EQ(fault->kind, FriFaultKind::kLost);
  EXPECT_TRUE(fault->to_answers);
  EXPECT_EQ(fault->share, 0.25);
  EXPECT_FALSE(fault->isActive(4.9));
  EXPECT_TRUE(fault->isActive(6.9));
  EXPECT_FALSE(fault->isActive(7.0));
  EXPECT_TRUE(friFaultOf("silence")->isActive(1e9));
  for (const auto* wrong : {"", "lots", "lost:2", "lost:-1", "lost@", "lost@a", "lost:nan", "late+",
                            "answer-silence", "answer-", "lost:0.1:0.2"})
    EXPECT_FALSE(friFaultOf(wrong)) << wrong;
}

TEST(FriFault, FilesNameTheLineThatIsWrong) {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "faults.txt";
  std::ofstream(file) << "# a bad line\nlost:0.01\n\nnan@3+0.1 # once\n";
  const auto faults = readFriFaults(file);
  ASSERT_TRUE(faults) << describe(faults.error());
  EXPECT_EQ(faults->size(), 2u);
  std::ofstream(file) << "lost\nlots\n";
  EXPECT_EQ(readFriFaults(file).error().line, 2);
  EXPECT_FALSE(readFriFaults(folder.path() / "none"));
}

TEST(FriFault, AnyTextIsAFaultOrARefusal) {
  std::mt19937 random(5);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = "answer-reordered:0.5@1+2";
    for (unsigned n = 0; n < 1 + random() % 3; ++n)
      text[random() % text.size()] = static_cast<char>(random());
    text.resize(random() % (text.size() + 1));
    if (const auto fault = friFaultOf(text)) {
      EXPECT_GE(fault->share, 0.0);
      EXPECT_LE(fault->share, 1.0);
    }
  }
}

/// The sequences in which ten datagrams come out.
std::vector<int> through(const std::string& fault) {
  const std::vector<FriFault> faults{*friFaultOf(fault)};
  FaultyWire wire(faults, false, 1);
  std::vector<int> out;
  for (int i = 0; i < 10; ++i) {
    devices::FriMeasurement m;
    m.sequence = static_cast<std::uint16_t>(i);
    m.measurement_period_s = 0.001F;
    Datagram bytes(devices::kFriMeasurementSize);
    encode(m, std::span<std::byte, devices::kFriMeasurementSize>(bytes));
    wire.put(bytes, i);
    for (const auto& each : wire.take()) {
      const auto read = devices::friMeasurementOf(each);
      out.push_back(read ? read->sequence : -1);
    }
    wire.endCycle();
  }
  return out;
}

TEST(FaultyWire, DoesToDatagramsWhatTheFaultSays) {
  EXPECT_EQ(through("lost@3+2"), (std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9}));
  EXPECT_EQ(through("silence@3+2"), (std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9}));
  EXPECT_EQ(through("duplicated@3+1"), (std::vector<int>{0, 1, 2, 3, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(through("reordered@3+1"), (std::vector<int>{0, 1, 2, 4, 3, 5, 6, 7, 8, 9}));
  EXPECT_EQ(through("late@3+1"), (std::vector<int>{0, 1, 2, 4, 3, 5, 6, 7, 8, 9}));
  for (const auto* spoilt : {"short@3+1", "long@3+1", "wrong_id@3+1", "nan@3+1"})
    EXPECT_EQ(through(spoilt), (std::vector<int>{0, 1, 2, -1, 4, 5, 6, 7, 8, 9})) << spoilt;
  EXPECT_EQ(through("answer-lost"), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

}  // namespace
}  // namespace mirrorarm::peers
