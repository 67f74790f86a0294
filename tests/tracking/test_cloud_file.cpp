#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/tracking/cloud_file.h"
#include "core/tracking/pose_file.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;

namespace {

class CloudFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("mirrorarm_clouds_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path holding(const std::string& text) const {
    const auto file = folder_ / "clouds.csv";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  FileError refusalOf(const std::string& text) const {
    const auto read = readClouds(holding(text));
    EXPECT_FALSE(read) << text;
    return read ? FileError{} : read.error();
  }

  std::filesystem::path folder_;
};

const std::string kHeader = "index,time_ns,x_m,y_m,z_m\n";

}  // namespace

TEST_F(CloudFile, GathersTheRowsOfAFrame) {
  const auto clouds =
      readClouds(holding(kHeader + "3,100,0.1,0.2,0.3\n3,100,1,2,3\n4,200,,,\n9,300,0,0,0.5\n"));
  ASSERT_TRUE(clouds) << describe(clouds.error());
  ASSERT_EQ(clouds->size(), 3u);
  EXPECT_EQ((*clouds)[0].index, 3);
  EXPECT_EQ(toNanoseconds((*clouds)[0].exposed_at), 100);
  ASSERT_EQ((*clouds)[0].points_C.size(), 2u);
  EXPECT_EQ((*clouds)[0].points_C[1], Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE((*clouds)[1].points_C.empty());
  EXPECT_EQ((*clouds)[2].index, 9);
}

TEST_F(CloudFile, RefusesWithLineAndColumn) {
  const auto number = refusalOf(kHeader + "0,0,0.1,0.2,0.3\n0,0,0.1,abc,0.3\n");
  EXPECT_EQ(number.line, 3);
  EXPECT_NE(number.reason.find("y_m"), std::string::npos);
  EXPECT_EQ(refusalOf(kHeader + "0,0,0.1,nan,0.3\n").line, 2);
  EXPECT_EQ(refusalOf(kHeader + "0,0,1,1,1\n0,5,1,1,1\n").line, 3);
  EXPECT_EQ(refusalOf(kHeader + "1,0,1,1,1\n0,5,1,1,1\n").line, 3);
  EXPECT_EQ(refusalOf(kHeader + "1,9,1,1,1\n2,5,1,1,1\n").line, 3);
  EXPECT_EQ(refusalOf(kHeader + "1.5,9,1,1,1\n").line, 2);
  EXPECT_NE(refusalOf("index,time_ns,x_m,y_m\n0,0,1,1\n").reason.find("z_m"), std::string::npos);
  EXPECT_NE(refusalOf(kHeader).reason.find("no frame"), std::string::npos);
  EXPECT_EQ(readClouds(folder_ / "absent.csv").error().reason, "cannot be read");
}

TEST_F(CloudFile, BrokenBytesAreRefusedOrReadNeverWorse) {
  std::string whole = kHeader;
  for (int i = 0; i < 30; ++i)
    whole += std::to_string(i / 10) + "," + std::to_string(i / 10 * 100) + ",0.1,-2e-3,.5\n";
  std::mt19937 rng(6);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> at(0, whole.size() - 1);
  for (int trial = 0; trial < 400; ++trial) {
    std::string broken = whole;
    for (int change = 0; change <= trial % 4; ++change) broken[at(rng)] = static_cast<char>(byte(rng));
    if (trial % 3 == 0) broken.resize(at(rng));
    const auto read = readClouds(holding(broken));
    EXPECT_TRUE(read || !read.error().reason.empty());
  }
}

TEST_F(CloudFile, PosesLeaveTheNumbersOfALostTargetEmpty) {
  PoseRow lost{7, "forearm", {}, {}};
  PoseRow found = lost;
  found.answer.status = TrackStatus::kTracked;
  found.answer.marker_count = 3;
  found.answer.matched_count = 2;
  found.answer.point_of_marker.fill(-1);
  found.answer.point_of_marker[0] = 4;
  found.answer.point_of_marker[2] = 1;
  found.answer.X_CT.translation().z() = 0.5;
  found.answer.covariance.diagonal() << 1e-6, 4e-6, 1e-6, 1e-8, 1e-8, 9e-8;
  found.points_C = {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)};
  const std::vector<PoseRow> rows{lost, found};
  ASSERT_TRUE(writePoses(folder_ / "poses.csv", rows));
  ASSERT_TRUE(writeMatches(folder_ / "matches.csv", rows));
  std::ifstream poses(folder_ / "poses.csv"), matches(folder_ / "matches.csv");
  std::string line;
  std::getline(poses, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  std::getline(poses, line);
  EXPECT_EQ(line, "7,0,forearm,lost,,,,,,,,,,,");
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
  std::getline(poses, line);
  EXPECT_EQ(line.find("7,0,forearm,tracked,0,0,0.5,0,0,0,1,0,2,0.0002999"), 0u) << line;
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
  std::getline(matches, line);
  std::getline(matches, line);
  EXPECT_EQ(line, "7,forearm,0,1,2,3");
  std::getline(matches, line);
  EXPECT_EQ(line, "7,forearm,2,4,5,6");
}
