#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/tracking/angle_file.h"
#include "core/tracking/arm_file.h"
#include "core/tracking/pose_table.h"
#include "tests/common/scratch_folder.h"
#include "tests/tracking/synthetic_arm.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

ArmRecord anArm() {
  SyntheticArm body;
  const auto calibrated = calibrateArm(body.movements(), Side::kRight);
  ArmRecord arm{calibrated->model, "2026-11-22T08:00:00Z", calibrated->quality};
  arm.model.upper_arm = "upper arm";
  arm.model.forearm = "Unterarm: links";
  arm.model.thorax = "chest";
  return arm;
}

std::string textOf(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void hold(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// `text` with some bytes changed and perhaps cut short.
std::string broken(std::string text, Noise& noise, int changes) {
  const auto any = [&noise](std::size_t below) {
    return static_cast<std::size_t>(noise.uniform(0.0, 0.999999) * static_cast<double>(below));
  };
  for (int change = 0; change <= changes; ++change) text[any(text.size())] = static_cast<char>(any(256));
  if (any(4) == 0) text.resize(any(text.size()));
  return text;
}

PoseRow rowOf(long long index, const std::string& target, const RigidTransform& X_CT, TrackStatus status) {
  PoseRow row{index, target, {}, {}};
  row.answer.status = status;
  row.answer.X_CT = X_CT;
  row.answer.covariance.setIdentity();
  row.answer.covariance *= 1e-8;
  row.answer.exposed_at = fromNanoseconds(1000 * index);
  return row;
}

class ArmFile : public testing::Test {
 protected:
  mirrorarm::test::ScratchFolder folder_;
  std::filesystem::path path_ = folder_.path() / "arm.yaml";
};

}  // namespace

TEST_F(ArmFile, ComesBackAsItWasWritten) {
  const ArmRecord arm = anArm();
  ASSERT_TRUE(writeArm(path_, arm));
  const auto read = readArm(path_);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->model.side, arm.model.side);
  EXPECT_EQ(read->model.upper_arm, arm.model.upper_arm);
  EXPECT_EQ(read->model.forearm, arm.model.forearm);
  EXPECT_EQ(read->model.thorax, arm.model.thorax);
  EXPECT_EQ(read->date, arm.date);
  EXPECT_LT((read->model.R_Uh - arm.model.R_Uh).norm(), 1e-9);
  EXPECT_LT((read->model.R_Ff - arm.model.R_Ff).norm(), 1e-9);
  EXPECT_LT((read->model.R_Rt - arm.model.R_Rt).norm(), 1e-9);
  EXPECT_LT((read->model.shoulder_U - arm.model.shoulder_U).norm(), 1e-9);
  EXPECT_LT((read->model.elbow_U - arm.model.elbow_U).norm(), 1e-9);
  EXPECT_NEAR(read->quality.upper_arm_m, arm.quality.upper_arm_m, 1e-6);
}

TEST_F(ArmFile, RefusesWhatIsNoArm) {
  ASSERT_TRUE(writeArm(path_, anArm()));
  const std::string good = textOf(path_);
  const auto refusalOf = [&](const std::string& what, const std::string& by) {
    hold(path_, replaced(good, what, by));
    const auto read = readArm(path_);
    EXPECT_FALSE(read) << by;
    return read ? std::string() : describe(read.error());
  };
  EXPECT_NE(refusalOf("side: right", "side: middle").find(":2: "), std::string::npos);
  EXPECT_NE(refusalOf("target: 'chest'", "target: 'upper arm'").find("twice"), std::string::npos);
  EXPECT_NE(refusalOf("shoulder_m: [", "shoulder_m: [.nan, ").find("shoulder_m"), std::string::npos);
  EXPECT_NE(refusalOf("humerus_xyzw: [", "humerus_xyzw: [7, ").find("humerus_xyzw"), std::string::npos);
  EXPECT_NE(refusalOf("elbow_m", "elbows_m").find("elbow"), std::string::npos);
  EXPECT_NE(refusalOf("arm/1", "arm/2").find("mirrorarm/arm/1"), std::string::npos);
}

TEST_F(ArmFile, BrokenBytesAreRefusedOrReadNeverWorse) {
  ASSERT_TRUE(writeArm(path_, anArm()));
  const std::string good = textOf(path_);
  Noise noise(5);
  for (int trial = 0; trial < 400; ++trial) {
    hold(path_, broken(good, noise, trial % 4));
    const auto read = readArm(path_);
    EXPECT_TRUE(read || !read.error().reason.empty());
  }
}

TEST_F(ArmFile, PosesComeBackFrameByFrame) {
  Noise noise(6);
  const RigidTransform X_1 = noise.pose(), X_2 = noise.pose();
  const std::vector<PoseRow> rows{
      rowOf(3, "a", X_1, TrackStatus::kTracked), rowOf(3, "b", X_2, TrackStatus::kPredicted),
      rowOf(4, "a", X_2, TrackStatus::kLost), rowOf(4, "b", X_2, TrackStatus::kTracked)};
  const auto poses = folder_.path() / "poses.csv";
  ASSERT_TRUE(writePoses(poses, rows));
  const auto frames = readTrackedPoses(poses);
  ASSERT_TRUE(frames) << describe(frames.error());
  ASSERT_EQ(frames->size(), 2U);
  EXPECT_EQ((*frames)[0].size(), 1U);
  EXPECT_LT(((*frames)[0].at("a").matrix() - X_1.matrix()).norm(), 1e-4);
  EXPECT_EQ((*frames)[1].count("b"), 1U);

  const std::string good = textOf(poses);
  hold(poses, replaced(good, "predicted", "foretold"));
  EXPECT_NE(describe(readTrackedPoses(poses).error()).find(":3: status 'foretold'"), std::string::npos);
  hold(poses, replaced(good, "\n4,", "\n2,"));
  EXPECT_NE(readTrackedPoses(poses).error().reason.find("falls"), std::string::npos);
  for (int trial = 0; trial < 400; ++trial) {
    hold(poses, broken(good, noise, trial % 4));
    const auto read = readTrackedPoses(poses);
    EXPECT_TRUE(read || !read.error().reason.empty());
  }
}

TEST_F(ArmFile, AnglesTellTheWorstOfTheTargets) {
  SyntheticArm body;
  ArmModel model = anArm().model;
  const ArmFrame frame = body.at({.flexion_deg = 60.0, .elevation_deg = 50.0});
  std::vector<PoseRow> rows;
  const TrackStatus statuses[] = {TrackStatus::kTracked, TrackStatus::kPredicted, TrackStatus::kLost};
  for (long long i = 0; i < 3; ++i) {
    rows.push_back(rowOf(i, model.upper_arm, frame.X_CU, TrackStatus::kTracked));
    rows.push_back(rowOf(i, model.forearm, frame.X_CF, statuses[i]));
    rows.push_back(rowOf(i, model.thorax, frame.X_CR, TrackStatus::kTracked));
  }
  const auto angles = angleRows(model, rows);
  ASSERT_EQ(angles.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(angles[i].status, statuses[i]);
  EXPECT_NEAR(angles[0].angles.value_rad[kElbowFlexion] / kDegree, 60.0, 1.5);
  const auto file = folder_.path() / "angles.csv";
  ASSERT_TRUE(writeAngles(file, angles));
  std::istringstream lines(textOf(file));
  for (std::string line; std::getline(lines, line);) EXPECT_EQ(std::ranges::count(line, ','), 16) << line;
}
