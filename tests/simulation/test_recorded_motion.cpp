#include <cmath>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/geometry/rigid_fit.h"
#include "core/simulation/recorded_motion.h"
#include "tests/simulation/small_trc.h"

namespace mirrorarm::simulation {
namespace {

namespace fs = std::filesystem;

const RigidTransform kX_BA =
    makeTransform(Eigen::Matrix3d(Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal()), {0.06, 0.0, 0.4});
const RecordedMotion::CameraPositions kCameras{Eigen::Vector3d::Zero(), Eigen::Vector3d(0.12, 0.0, 0.0)};

std::vector<Eigen::Vector3d> places(const RecordedMotion& motion, double phase_s) {
  std::vector<Disc> discs(10);
  motion.discsAt(phase_s, discs);
  std::vector<Eigen::Vector3d> p;
  for (const auto& disc : discs) p.push_back(disc.p_B);
  return p;
}

class RecordedMotionTest : public ::testing::Test {
 protected:
  void SetUp() override { std::ofstream(file_) << trcText('\t', "mm", 50); }
  void TearDown() override { fs::remove(file_); }
  fs::path file_ = fs::temp_directory_path() / ("mirrorarm_motion_" + std::to_string(::getpid()) + ".trc");
};

TEST_F(RecordedMotionTest, StartsAtThePoseAsked) {
  const auto motion = RecordedMotion::read(file_, kX_BA, kCameras);
  ASSERT_TRUE(motion) << describe(motion.error());
  const auto forearm = motion->forearmAt(0.0);
  EXPECT_NEAR((0.5 * (forearm.elbow_B + forearm.wrist_B) - kX_BA.translation()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((forearm.wrist_B - forearm.elbow_B).normalized().dot(kX_BA.linear().col(0)), 1.0, 1e-9);
}

TEST_F(RecordedMotionTest, DiscsLookToTheCamerasAtTheStart) {
  const auto motion = RecordedMotion::read(file_, kX_BA, kCameras);
  std::vector<Disc> discs(10);
  motion->discsAt(0.0, discs);
  const Eigen::Vector3d between = 0.5 * (kCameras[0] + kCameras[1]);
  for (const auto& disc : discs)
    EXPECT_LT(std::acos(disc.normal_B.normalized().dot((between - disc.p_B).normalized())), 0.62);
}

TEST_F(RecordedMotionTest, GoesToAndFroWithoutJumps) {
  const auto motion = RecordedMotion::read(file_, kX_BA, kCameras);
  constexpr double kStep = 1e-3;
  auto before = places(*motion, 0.0);
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for (double t = kStep; t < 3.0; t += kStep) {
    const auto now = places(*motion, t);
    const Eigen::Vector3d next = (now[0] - before[0]) / kStep;
    EXPECT_LT((next - velocity).norm(), 1e-3) << t;  // below 1 m/s^2
    velocity = next;
    before = now;
  }
  EXPECT_LT(fitRms(RigidTransform::Identity(), places(*motion, 0.0), places(*motion, 2.0 * (0.49 + 0.25))),
            1e-9);
}

TEST_F(RecordedMotionTest, RefusesAForearmWithoutLength) {
  auto text = trcText('\t', "mm", 50);
  std::ofstream(file_) << text.substr(0, text.find("WRIST"));
  EXPECT_FALSE(RecordedMotion::read(file_, kX_BA, kCameras));
}

TEST_F(RecordedMotionTest, KeepsTheSkinsDeformationOfARealArm) {
  const fs::path real = fs::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc";
  if (!fs::exists(real)) GTEST_SKIP() << real << " is absent";
  const auto motion = RecordedMotion::read(real, kX_BA, kCameras);
  ASSERT_TRUE(motion) << describe(motion.error());
  const auto start = places(*motion, 0.0), end = places(*motion, 0.92 + 0.25);
  const double rms = fitRms(fitByKabsch(start, end), start, end);
  EXPECT_GT(rms, 0.0005);
  EXPECT_LT(rms, 0.004);
  EXPECT_GT((start[0] - end[0]).norm(), 0.02);
}

}  // namespace
}  // namespace mirrorarm::simulation
