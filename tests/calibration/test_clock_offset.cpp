#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/calibration/clock_offset.h"
#include "core/geometry/small_motion.h"
#include "tests/calibration/fuzz.h"
#include "tests/calibration/stations.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

/// A robot whose flange sways about two axes, unevenly, and a camera with a clock of its own.
struct MovementMaker {
  RigidTransform X_PC = StationMaker().X_FC;
  RigidTransform X_QM = StationMaker().X_BM;
  CameraMount mount = CameraMount::kInHand;
  double duration_s = 20.0;
  double offset_s = 0.0437;  ///< robot's time minus camera's
  double noise_m = 0.00005;
  double noise_deg = 0.02;
  double swing_rad = 0.25;
  bool about_one_axis = false;
  bool repeats = false;
  unsigned seed = 1;

  [[nodiscard]] RigidTransform flange(double t) const {
    const double a = repeats ? std::sin(2.0 * 3.14159265 * t / 0.8)
                             : std::sin(1.1 * t + 0.8 * std::sin(0.37 * t)) + 0.4 * std::sin(3.1 * t);
    const double b = about_one_axis ? 0.0 : repeats ? a : std::cos(0.8 * t + 1.1 * std::sin(0.23 * t));
    const Eigen::Vector3d turn(swing_rad * b, swing_rad * a, 0.3 * swing_rad * b);
    return makeTransform(turnBy(turn) * Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                         Eigen::Vector3d(0.5 + 0.1 * a, 0.1 * b, 0.45 + 0.03 * a * b));
  }

  [[nodiscard]] std::vector<TimedPose> robot() const {
    std::vector<TimedPose> poses;
    for (double t = 100.0; t < 100.0 + duration_s; t += 0.001) poses.push_back({t, flange(t)});
    return poses;
  }

  [[nodiscard]] std::vector<TimedPose> camera() const {
    StationMaker noise;
    noise.noise_m = noise_m;
    noise.noise_deg = noise_deg;
    noise.random.seed(seed);
    std::vector<TimedPose> poses;
    for (double t = 100.5; t < 99.5 + duration_s; t += 1.0 / 24.0) {
      const RigidTransform X_BF = flange(t);
      const RigidTransform X_PQ = mount == CameraMount::kInHand ? X_BF.inverse() : X_BF;
      poses.push_back({t - offset_s, X_PC.inverse() * X_PQ * X_QM * noise.noise()});
    }
    return poses;
  }
};

TEST(ClockOffset, IsFoundFarBelowTheFrameInterval) {
  for (unsigned seed = 0; seed < 2; ++seed) {
    MovementMaker maker;
    maker.seed = seed;
    maker.offset_s = -0.02 + 0.0213 * seed;
    const auto found = solveClockOffset(maker.robot(), maker.camera(), CameraMount::kInHand);
    ASSERT_TRUE(found) << reason(found.error());
    EXPECT_NEAR(found->offset_s, maker.offset_s, 0.001);
    EXPECT_NEAR(found->offset_s, maker.offset_s, 5.0 * found->sigma_s + 2e-5);
    EXPECT_LT(found->sigma_s, 0.001);
    EXPECT_GT(found->correlation, 0.95);
    EXPECT_LT((found->hand_eye.X_PC.translation() - maker.X_PC.translation()).norm(), 0.0005);
    EXPECT_LT(found->median_m, 0.0005);
    EXPECT_FALSE(found->was_camera_inverted);
  }
}

TEST(ClockOffset, OutliersDoNotMoveIt) {
  MovementMaker maker;
  auto camera = maker.camera();
  for (std::size_t i = 5; i < camera.size(); i += 12) camera[i].X.translation().x() += 0.04;
  const auto found = solveClockOffset(maker.robot(), camera, CameraMount::kInHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_NEAR(found->offset_s, maker.offset_s, 0.001);
  EXPECT_NEAR(static_cast<double>(found->hand_eye.outliers.size()), static_cast<double>(camera.size()) / 12.0,
              3.0);
}

TEST(ClockOffset, CameraBesideTheRobot) {
  MovementMaker maker;
  maker.mount = CameraMount::kToHand;
  maker.X_PC = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitY())),
                             Eigen::Vector3d(0.9, -0.5, 0.8));
  maker.X_QM = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX())),
                             Eigen::Vector3d(0.05, 0.02, 0.12));
  const auto found = solveClockOffset(maker.robot(), maker.camera(), CameraMount::kToHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_NEAR(found->offset_s, maker.offset_s, 0.001);
  EXPECT_LT((found->hand_eye.X_PC.translation() - maker.X_PC.translation()).norm(), 0.002);
}

TEST(ClockOffset, AnInvertedCameraStreamIsTurnedRoundAndSaid) {
  MovementMaker maker;
  auto camera = maker.camera();
  for (auto& pose : camera) pose.X = pose.X.inverse();
  const auto found = solveClockOffset(maker.robot(), camera, CameraMount::kInHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_TRUE(found->was_camera_inverted);
  EXPECT_NEAR(found->offset_s, maker.offset_s, 0.001);
  EXPECT_LT((found->hand_eye.X_PC.translation() - maker.X_PC.translation()).norm(), 0.0005);
}

ClockError refusalOf(const MovementMaker& maker, const MovementMaker& other) {
  const auto found = solveClockOffset(maker.robot(), other.camera(), CameraMount::kInHand);
  EXPECT_FALSE(found);
  return found ? ClockError::kNotSolved : found.error();
}
ClockError refusalOf(const MovementMaker& maker) { return refusalOf(maker, maker); }

TEST(ClockOffset, RefusesWhatCannotTell) {
  MovementMaker brief;
  brief.duration_s = 4.0;
  EXPECT_EQ(refusalOf(brief), ClockError::kTooShort);
  MovementMaker still;
  still.swing_rad = 0.0005;
  EXPECT_EQ(refusalOf(still), ClockError::kTooStill);
  MovementMaker hinge;
  hinge.about_one_axis = true;
  EXPECT_EQ(refusalOf(hinge), ClockError::kNotSolved);
  MovementMaker repeating;
  repeating.repeats = true;
  EXPECT_EQ(refusalOf(repeating), ClockError::kAmbiguous);
  MovementMaker apart;
  apart.offset_s = 60.0;
  EXPECT_EQ(refusalOf(apart), ClockError::kTooShort);
  MovementMaker one, other;
  other.offset_s = 1.8;  // beyond the search
  EXPECT_EQ(refusalOf(one, other), ClockError::kNoAgreement);
}

TEST(ClockOffset, AnInvertedRobotIsNamed) {
  MovementMaker maker;
  auto robot = maker.robot();
  for (auto& pose : robot) pose.X = pose.X.inverse();
  const auto found = solveClockOffset(robot, maker.camera(), CameraMount::kInHand);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(), ClockError::kRobotInverted);
}

TEST(ClockOffset, TimesInMillisecondsAreNamed) {
  MovementMaker maker;
  auto robot = maker.robot();
  for (auto& pose : robot) pose.time_s *= 1e3;
  EXPECT_EQ(solveClockOffset(robot, maker.camera(), CameraMount::kInHand).error(), ClockError::kTooLong);
}

// A camera on a body that Vicon follows, both by hand; its poses are the camera in the board.
TEST(ClockOffset, RealStreamsOfViconAndCamera) {
  const auto folder = std::filesystem::path(SHARED_DATA) / "ethz-handeye";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const auto robot = readPoseStream(folder / "2017-04-09-18-13-10_vicon_prime_sense.csv");
  const auto camera = readPoseStream(folder / "2017-04-09-18-13-10_W_camera_rgb_image_raw.csv");
  ASSERT_TRUE(robot && camera);
  const auto found = solveClockOffset(*robot, *camera, CameraMount::kInHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_TRUE(found->was_camera_inverted);
  EXPECT_NEAR(found->offset_s, 0.04, 0.01);
  EXPECT_LT(found->median_m, 0.009);
  EXPECT_LT(found->median_rad, 1.2 * std::numbers::pi / 180.0);
  EXPECT_LT((found->hand_eye.X_PC.translation() - Eigen::Vector3d(0.079, 0.044, 0.028)).norm(), 0.01);
}

std::string readingOf(const std::string& text) {
  const test::ScratchFolder folder;
  writeText(folder / "stream.csv", text);
  const auto read = readPoseStream(folder / "stream.csv");
  return read ? std::to_string(read->size()) + " poses"
              : std::to_string(read.error().line) + ": " + read.error().reason;
}

TEST(PoseStream, ReadsWithAndWithoutHeader) {
  EXPECT_EQ(readingOf("0.1,0,0,0,0,0,0,1\n0.2,0,0,0,0,0,0,1\n"), "2 poses");
  EXPECT_EQ(readingOf("time_ns,tx_m,ty_m,tz_m,qx,qy,qz,qw\n100,0,0,0,0,0,0,1\n"), "1 poses");
  EXPECT_EQ(readingOf("index,time_ns,target,status,tx_m,ty_m,tz_m,qx,qy,qz,qw\n"
                      "0,100,a,tracked,0,0,0,0,0,0,1\n1,200,a,lost,,,,,,,\n2,300,a,tracked,0,0,0,0,0,0,1\n"),
            "2 poses");
  EXPECT_EQ(readingOf("0.1,0,0,0,0,0,0,1\n0.1,1,0,0,0,0,0,1\n"), "1 poses");
}

TEST(PoseStream, RefusalsNameTheLine) {
  EXPECT_EQ(readingOf("0.1,0,0,0,0,0,0,1\n0.05,0,0,0,0,0,0,1\n"), "2: the time is before the one above");
  EXPECT_EQ(readingOf("0.1,0,0,0,0,0,0,1\n0.2,0,x,0,0,0,0,1\n"), "2: ty_m is not a finite number: 'x'");
  EXPECT_EQ(readingOf("0.1,0,0,0,0,0,0,2\n"), "1: the quaternion is not of unit norm");
  EXPECT_EQ(readingOf("0.1,0,0\n"), "1: has no header and 3 cells: t,x,y,z,qx,qy,qz,qw are 8");
  EXPECT_EQ(readingOf("tx_m,ty_m\n0,0\n"), "1: has no column time_s or time_ns");
  EXPECT_EQ(readingOf("time_s,q1,q2\n0,0,0\n"), "1: has no column tx_m");
  EXPECT_FALSE(readPoseStream("/nowhere/stream.csv"));
}

TEST(PoseStream, DamagedFilesNeverCrash) {
  const test::ScratchFolder folder;
  writeText(
      folder / "s.csv",
      "time_s,tx_m,ty_m,tz_m,qx,qy,qz,qw\n0.1,0,0,0,0,0,0,1\n0.2,0.1,0,0,0,1,0,0\n0.3,0,0.2,0,1,0,0,0\n");
  fuzz(folder / "s.csv", 200, [](const auto& file) {
    const auto read = readPoseStream(file);
    if (!read) return;
    for (const auto& pose : *read) EXPECT_TRUE(isRigid(pose.X) && std::isfinite(pose.time_s));
  });
}

}  // namespace
}  // namespace mirrorarm::calibration
