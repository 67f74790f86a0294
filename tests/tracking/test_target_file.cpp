#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "core/tracking/target_file.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

class TargetFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("mirrorarm_target_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path() const { return folder_ / "target.yaml"; }
  std::filesystem::path holding(const std::string& text) const {
    std::ofstream(path(), std::ios::binary) << text;
    return path();
  }
  FileError refusalOf(const std::string& text) const {
    const auto read = readTarget(holding(text));
    EXPECT_FALSE(read) << text;
    return read ? FileError{} : read.error();
  }

  std::filesystem::path folder_;
};

std::string yaml(const std::string& markers, const std::string& rest = "") {
  return "format: mirrorarm/target/1\nname: forearm\nmarker_diameter_m: 0.007\nmarkers_m: " + markers + "\n" +
         rest;
}

}  // namespace

TEST_F(TargetFile, ComesBackAsItWasWritten) {
  Target target = forearm();
  target.name = "linker Unterarm: 2";
  Eigen::Matrix3d covariance;
  covariance << 4e-9, 1e-9, 0.0, 1e-9, 3e-9, -2e-10, 0.0, -2e-10, 9e-9;
  target.markers_covariance_m2.assign(10, covariance);
  ASSERT_TRUE(writeTarget(path(), target));
  const auto read = readTarget(path());
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->name, target.name);
  EXPECT_EQ(read->marker_diameter_m, target.marker_diameter_m);
  EXPECT_EQ(read->markers_T, target.markers_T);
  EXPECT_EQ(read->markers_covariance_m2, target.markers_covariance_m2);
}

TEST_F(TargetFile, RefusesWhatNoPoseCanComeFrom) {
  const auto two = refusalOf(yaml("[[0, 0, 0], [0.1, 0, 0]]"));
  EXPECT_NE(two.reason.find("fewer than 3"), std::string::npos) << two.reason;
  EXPECT_EQ(two.line, 4);
  const auto line = refusalOf(yaml("[[0, 0, 0], [0.1, 0, 0], [0.05, 0, 0]]"));
  EXPECT_NE(line.reason.find("one line"), std::string::npos) << line.reason;
  const auto close = refusalOf(yaml("[[0, 0, 0], [0.1, 0, 0], [0.1, 0.005, 0], [0, 0.1, 0]]"));
  EXPECT_NE(close.reason.find("closer"), std::string::npos) << close.reason;
  std::string crowd = "[";
  for (int i = 0; i < 65; ++i)
    crowd.append("[").append(std::to_string(i)).append(i % 2 ? ", 1, 0]," : ", 0, 0],");
  const auto many = refusalOf(yaml(crowd + "]"));
  EXPECT_NE(many.reason.find("more than 64"), std::string::npos) << many.reason;
}

TEST_F(TargetFile, RefusesWithTheLineAndTheKey) {
  const std::string good = "[[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]]";
  EXPECT_NE(refusalOf(yaml("[[0, 0, 0], [0.1, .nan, 0], [0, 0.1, 0]]")).reason.find("finite"),
            std::string::npos);
  EXPECT_NE(refusalOf(yaml("[[0, 0], [0.1, 0, 0], [0, 0.1, 0]]")).reason.find("three"), std::string::npos);
  EXPECT_EQ(refusalOf(yaml(good, "colour: red\n")).line, 5);
  EXPECT_NE(
      refusalOf(yaml(good, "markers_covariance_m2: [[1e-8, 0, 0, 1e-8, 0, 1e-8]]\n")).reason.find("one item"),
      std::string::npos);
  EXPECT_NE(refusalOf("format: mirrorarm/target/2\n").reason.find("mirrorarm/target/1"), std::string::npos);
  EXPECT_NE(refusalOf("format: mirrorarm/target/1\nname: 'a,b'\nmarker_diameter_m: 0.007\nmarkers_m: " + good)
                .reason.find("name"),
            std::string::npos);
  EXPECT_NE(refusalOf("format: mirrorarm/target/1\nname: a\nmarker_diameter_m: 0\nmarkers_m: " + good)
                .reason.find("above 0"),
            std::string::npos);
  EXPECT_EQ(readTarget(folder_ / "absent.yaml").error().reason, "cannot be read");
}

TEST_F(TargetFile, BrokenBytesAreRefusedOrReadNeverWorse) {
  ASSERT_TRUE(writeTarget(path(), forearm()));
  std::stringstream text;
  text << std::ifstream(path()).rdbuf();
  const std::string whole = text.str();
  std::mt19937 rng(5);
  std::uniform_int_distribution<int> byte(0, 255), kind(0, 3);
  std::uniform_int_distribution<std::size_t> at(0, whole.size() - 1);
  for (int trial = 0; trial < 400; ++trial) {
    std::string broken = whole;
    for (int change = 0; change <= trial % 4; ++change) broken[at(rng)] = static_cast<char>(byte(rng));
    if (kind(rng) == 0) broken.resize(at(rng));
    const auto read = readTarget(holding(broken));
    EXPECT_TRUE(read || !read.error().reason.empty());
  }
}
