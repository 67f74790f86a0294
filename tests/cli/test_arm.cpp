#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/tracking/pose_file.h"
#include "core/tracking/target_file.h"
#include "program.h"
#include "tests/tracking/synthetic_arm.h"

// From poses to an arm's bones to joint angles, through the program itself.
namespace mirrorarm::cli {
namespace {

using namespace tracking;
using namespace tracking::test;

Target upperArmTarget() {
  Target target = forearm();
  target.name = "upper";
  for (auto& marker : target.markers_T)
    marker = Vector3d(0.8 * marker.y(), -1.1 * marker.x(), 0.9 * marker.z());
  return target;
}

std::filesystem::path writeMovement(const mirrorarm::test::ScratchFolder& folder, const std::string& name,
                                    const std::vector<ArmFrame>& frames) {
  std::vector<PoseRow> rows;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    PoseRow row;
    row.index = static_cast<long long>(i);
    row.answer.status = TrackStatus::kTracked;
    row.target = "upper";
    row.answer.X_CT = frames[i].X_CU;
    rows.push_back(row);
    row.target = "forearm";
    row.answer.X_CT = frames[i].X_CF;
    rows.push_back(row);
  }
  const auto file = folder / name;
  EXPECT_TRUE(writePoses(file, rows));
  return file;
}

/// Clouds of both targets while the elbow bends from 20 to 100 degrees.
void writeClouds(const std::filesystem::path& file, SyntheticArm& arm) {
  std::ofstream out(file);
  out.precision(9);
  out << "index,time_ns,x_m,y_m,z_m\n";
  const auto write = [&](int i, const RigidTransform& X_CT, const Target& target) {
    for (const auto& marker_T : target.markers_T) {
      const Vector3d p = X_CT * marker_T + arm.noise.gaussian(0.00005);
      out << i << ',' << i * 40000000LL << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
    }
  };
  for (int i = 0; i <= 40; ++i) {
    const ArmFrame frame = arm.at({.flexion_deg = 20.0 + 2.0 * i, .elevation_deg = 40.0});
    write(i, frame.X_CU, upperArmTarget());
    write(i, frame.X_CF, forearm());
  }
}

class Arm : public testing::Test {
 protected:
  void SetUp() override {
    const ArmMovements moves = arm_.movements();
    movements_ = "--posture " + writeMovement(folder_, "posture.csv", moves.posture).string() +
                 " --flexion " + writeMovement(folder_, "flexion.csv", moves.flexion).string() +
                 " --rotation " + writeMovement(folder_, "rotation.csv", moves.rotation).string() +
                 " --circles " + writeMovement(folder_, "circles.csv", moves.circles).string();
  }
  [[nodiscard]] cli::Run findBones(const std::string& more) const {
    return run("arm --upper-arm upper --forearm forearm --out " + (folder_ / "arm.yaml").string() + " " +
               movements_ + " " + more);
  }

  SyntheticArm arm_;
  mirrorarm::test::ScratchFolder folder_;
  std::string movements_;
};

TEST_F(Arm, BonesAreFoundAndTrackGivesTheAngles) {
  const auto found = findBones("--side right --json");
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_NEAR(found.json()["upper_arm_mm"], 300.0, 4.0);
  EXPECT_EQ(found.json()["reference"], "camera");

  ASSERT_TRUE(writeTarget(folder_ / "upper.yaml", upperArmTarget()));
  ASSERT_TRUE(writeTarget(folder_ / "forearm.yaml", forearm()));
  writeClouds(folder_ / "clouds.csv", arm_);
  const auto angles = folder_ / "angles.csv";
  const auto tracked =
      run("track --clouds " + (folder_ / "clouds.csv").string() + " --target " +
          (folder_ / "upper.yaml").string() + " --target " + (folder_ / "forearm.yaml").string() + " --out " +
          (folder_ / "poses.csv").string() + " --arm " + (folder_ / "arm.yaml").string() + " --angles " +
          angles.string() + " --json");
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  const auto range = tracked.json()["arm"]["elbow_flexion_deg"];
  EXPECT_NEAR(range[0], 20.0, 2.0);
  EXPECT_NEAR(range[1], 100.0, 2.0);
  const auto table = CsvTable::read(angles);
  ASSERT_TRUE(table) << describe(table.error());
  EXPECT_EQ(table->rows().size(), 41U);
}

TEST_F(Arm, WhatShowsNoArmIsRefusedInOneLine) {
  const auto refused = [](const cli::Run& done) {
    EXPECT_EQ(done.exit_code, 2) << done.err;
    EXPECT_EQ(done.lines(), 1) << done.err;
    return done.err;
  };
  EXPECT_NE(refused(findBones("--side left")).find("rotation.csv: does not begin palm up"),
            std::string::npos);
  EXPECT_NE(refused(findBones("--side right --thorax chest")).find("posture.csv: no frame"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "arm.yaml"));
  ASSERT_TRUE(writeTarget(folder_ / "upper.yaml", upperArmTarget()));
  writeClouds(folder_ / "clouds.csv", arm_);
  ASSERT_EQ(findBones("--side right").exit_code, 0);
  const std::string track = "track --clouds " + (folder_ / "clouds.csv").string() + " --target " +
                            (folder_ / "upper.yaml").string() + " --out " + (folder_ / "poses.csv").string();
  EXPECT_NE(
      refused(run(track + " --arm " + (folder_ / "arm.yaml").string() + " --angles a.csv")).find("'forearm'"),
      std::string::npos);
  refused(run(track + " --arm " + (folder_ / "arm.yaml").string()));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "poses.csv"));
}

}  // namespace
}  // namespace mirrorarm::cli
