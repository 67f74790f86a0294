#include <fstream>
#include <random>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/simulation/trc_file.h"
#include "tests/simulation/small_trc.h"

namespace mirrorarm::simulation {
namespace {

namespace fs = std::filesystem;

class TrcFileTest : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  FromFile<MarkerMotion> read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return readTrc(file_, wanted_);
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  }

  fs::path file_ = fs::temp_directory_path() / ("mirrorarm_" + std::to_string(::getpid()) + ".trc");
  std::vector<std::string_view> wanted_{kForearmMarkers.begin(), kForearmMarkers.end()};
};

TEST_F(TrcFileTest, ReadsTabsAndCommasMillimetresAndMetres) {
  for (const char separator : {'\t', ','})
    for (const char* units : {"mm", "m"}) {
      const auto motion = read(trcText(separator, units, 20));
      ASSERT_TRUE(motion) << describe(motion.error());
      EXPECT_EQ(motion->rate_hz, 100.0);
      EXPECT_EQ(motion->markers.size(), 10u);
      ASSERT_EQ(motion->positions_m.size(), 20u);
      EXPECT_NEAR(motion->positions_m[0][9].x(), 0.23, 1e-9);
    }
}

TEST_F(TrcFileTest, ReadsFewerRowsThanTheHeaderSays) {
  EXPECT_TRUE(read(replaced(trcText(',', "mm", 20), "100,100,20", "100,100,652")));
}

TEST_F(TrcFileTest, RefusesWithTheLine) {
  const std::string good = trcText(',', "mm", 20);
  const struct {
    const char* from;
    const char* to;
    int line;
  } wrongs[] = {{"PathFileType", "Path", 1},
                {"(X/Y/Z)", "(X/Y)", 1},
                {"NumMarkers", "Markers", 2},
                {"100,100,20", "0,100,20", 3},
                {"100,100,20", "x,100,20", 3},
                {"20,11,mm", "20,11,inch", 3},
                {"20,11,mm", "20,12,mm", 4},
                {"20,11,mm", "19,11,mm", 26},
                {"WRIST", "wrist", 4},
                {"LARMm", "LARMl", 4},
                {"Frame#", "Frame", 4},
                {"X3,Y3", "X3,X3", 5},
                {"\n5,0.04", "\n6,0.04", 11},
                {"\n5,0.04", "\n5,0.05", 11},
                {"\n5,0.04", "\n5,", 11},
                {"\n2,0.01,,,,", "\n2,0.01,,,,nan", 8},
                {"\n2,0.01,,,,", "\n2,0.01,,,,,", 8},
                {"\n2,0.01,,,,", "\n2,0.01,,,", 8},
                {"\n2,0.01,,,,", "\n2,0.01,x,,,", 8}};
  for (const auto& wrong : wrongs) {
    const auto motion = read(replaced(good, wrong.from, wrong.to));
    ASSERT_FALSE(motion) << wrong.from << " -> " << wrong.to;
    EXPECT_EQ(motion.error().line, wrong.line) << wrong.to << ": " << describe(motion.error());
  }
  EXPECT_FALSE(read(""));
  EXPECT_FALSE(read(good.substr(0, good.size() - 3)));
  EXPECT_FALSE(read(good.substr(0, good.find("\n2,"))));
  fs::remove(file_);
  EXPECT_EQ(readTrc(file_, wanted_).error().reason, "cannot be read");
}

TEST_F(TrcFileTest, SurvivesRandomChanges) {
  const std::string good = trcText(',', "mm", 5);
  std::mt19937 random(3);
  for (int i = 0; i < 800; ++i) {
    std::string bad = good;
    for (int n = 0; n < 1 + i % 3; ++n) bad[random() % bad.size()] = static_cast<char>(random());
    if (i % 4 == 0) bad.resize(random() % bad.size());
    const auto motion = read(bad);
    if (motion)
      EXPECT_GE(motion->positions_m.size(), 2u);
    else
      EXPECT_FALSE(motion.error().reason.empty());
  }
}

TEST_F(TrcFileTest, ReadsARealRecording) {
  const fs::path real = fs::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc";
  if (!fs::exists(real)) GTEST_SKIP() << real << " is absent";
  const auto motion = readTrc(real, wanted_);
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(motion->positions_m.size(), 93u);
  EXPECT_NEAR(motion->positions_m[0][0].x(), 0.7109666, 1e-9);
}

}  // namespace
}  // namespace mirrorarm::simulation
