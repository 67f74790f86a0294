#include <cmath>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "core/simulation/bench.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::simulation {
namespace {

const std::vector<MinimumJerkLeg> kReach{{{-0.08, 0.0, 0.0}, 0.0, 1.0, 0.2},
                                         {{0.0, 0.0, 0.0}, 0.0, 1.0, 0.2}};

class BenchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    time_.set(fromNanoseconds(1'000'000'000));
    settings_.resources = RESOURCES;
    settings_.legs = kReach;
    settings_.own_pace = false;
  }
  std::unique_ptr<Bench> make() {
    auto bench = Bench::make(settings_, time_);
    EXPECT_TRUE(bench) << describe(bench.error());
    return std::move(*bench);
  }
  /// Lets time pass in servo cycles; the newest frame, if one came.
  std::optional<camera::StereoFrame> run(Bench& bench, double seconds) {
    std::optional<camera::StereoFrame> newest;
    for (int i = 0; i < static_cast<int>(seconds / 0.005 + 0.5); ++i) {
      time_.set(time_.now() + std::chrono::milliseconds(5));
      static_cast<void>(bench.robot().read());
      if (auto frame = bench.cameras().next(Seconds(0.0))) newest = *frame;
    }
    return newest;
  }
  static double brightnessAt(const camera::GreyImage& image, const Eigen::Vector2d& pixel) {
    return image.view().at(static_cast<int>(std::lround(pixel.x())),
                           static_cast<int>(std::lround(pixel.y())));
  }

  ManualTime time_;
  BenchSettings settings_;
};

TEST(BenchLayout, TheHandHoldsTheCameraWhereTheBenchIsLaidOutFor) {
  const auto hand = bench_layout::hand(RESOURCES);
  ASSERT_TRUE(hand) << describe(hand.error());
  EXPECT_TRUE((bench_layout::startX_BF() * hand->X_FC).isApprox(bench_layout::startX_BC(), 1e-12));
}

TEST_F(BenchTest, StandsWhereItIsMeantTo) {
  for (const auto lens : {camera::LensModel::kKannalaBrandt, camera::LensModel::kBrownConrady}) {
    settings_.lens = lens;
    const auto bench = make();
    EXPECT_EQ(bench->rig().left.intrinsics().model, lens);
    const auto truth = bench->truthAt(time_.now());
    EXPECT_LT((truth.X_BF.linear().col(2) + Eigen::Vector3d::UnitZ()).norm(), 1e-3);
    const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
    ASSERT_EQ(truth.discs.size(), 10u);
    for (const auto& disc : truth.discs) {
      const Eigen::Vector3d p_C = X_CB * disc.p_B;
      EXPECT_NEAR(p_C.z(), 0.38, 0.05);
      EXPECT_TRUE(bench->rig().left.sees(*bench->rig().left.project(p_C), 50.0));
      EXPECT_TRUE(bench->rig().right.sees(*bench->rig().right.project(bench->rig().X_RC * p_C), 50.0));
    }
    EXPECT_LT(((truth.X_BF * bench->X_FE()).translation() - truth.impaired.wrist_B).norm(), 1e-9);
    const auto state = bench->robot().read();
    for (int i = 0; i < 7; ++i) {
      const auto& joint = bench->arm().joints[static_cast<std::size_t>(i)];
      EXPECT_GT(state->q_rad[i], joint.lower_rad + 0.3);
      EXPECT_LT(state->q_rad[i], joint.upper_rad - 0.3);
    }
  }
}

TEST_F(BenchTest, ImagesShowTheDiscsWhereTheTruthSays) {
  const auto bench = make();
  bench->setPatientMoving(true);
  const auto frame = run(*bench, 0.8);
  ASSERT_TRUE(frame);
  const auto truth = bench->truthAt(frame->exposed_at);
  const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
  for (const auto& disc : truth.discs) {
    const Eigen::Vector3d p_C = X_CB * disc.p_B;
    EXPECT_GT(brightnessAt(frame->left, *bench->rig().left.project(p_C)), 40.0);
    EXPECT_GT(brightnessAt(frame->right, *bench->rig().right.project(bench->rig().X_RC * p_C)), 40.0);
  }
}

TEST_F(BenchTest, ThePatientMovesOnlyWhenAsked) {
  const auto bench = make();
  const Eigen::Vector3d start = bench->truthAt(time_.now()).discs[0].p_B;
  static_cast<void>(run(*bench, 0.5));
  EXPECT_EQ(bench->truthAt(time_.now()).discs[0].p_B, start);
  bench->setPatientMoving(true);
  static_cast<void>(run(*bench, 1.25));
  EXPECT_NEAR(start.x() - bench->truthAt(time_.now()).discs[0].p_B.x(), 0.08, 1e-6);
}

TEST_F(BenchTest, TheCamerasRideOnTheRobot) {
  const auto bench = make();
  const auto before = bench->truthAt(time_.now());
  auto wish = bench->robot().read()->q_rad;
  for (int i = 0; i < 200; ++i) {
    wish[0] += 0.0005;
    ASSERT_TRUE(bench->robot().command({wish}));
    static_cast<void>(run(*bench, 0.005));
  }
  const auto frame = run(*bench, 0.2);
  ASSERT_TRUE(frame);
  const auto truth = bench->truthAt(frame->exposed_at);
  EXPECT_GT((truth.X_BF.translation() - before.X_BF.translation()).norm(), 0.04);
  const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
  EXPECT_GT(brightnessAt(frame->left, *bench->rig().left.project(X_CB * truth.discs[3].p_B)), 40.0);
}

TEST_F(BenchTest, HiddenTargetsAreDark) {
  const auto bench = make();
  bench->hideTarget(true);
  const auto frame = run(*bench, 0.1);
  ASSERT_TRUE(frame);
  const auto truth = bench->truthAt(frame->exposed_at);
  const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
  for (const auto& disc : truth.discs)
    EXPECT_LT(brightnessAt(frame->left, *bench->rig().left.project(X_CB * disc.p_B)), 20.0);
}

TEST_F(BenchTest, FaultsReachTheDevices) {
  const auto bench = make();
  bench->failCameras(true);
  EXPECT_FALSE(run(*bench, 0.2));
  bench->silenceRobot(true);
  EXPECT_EQ(bench->robot().read().error(), robot::LinkFault::kNoAnswer);
  bench->failCameras(false);
  bench->silenceRobot(false);
  EXPECT_TRUE(run(*bench, 0.2));
}

TEST_F(BenchTest, RunsInItsOwnPaceFromSeveralThreads) {
  const SteadyTime steady;
  settings_.own_pace = true;
  const auto bench = std::move(*Bench::make(settings_, steady));
  bench->setPatientMoving(true);
  int frames = 0;
  std::jthread cameras([&] {
    for (int i = 0; i < 5; ++i) frames += bench->cameras().next(Seconds(1.0)).has_value() ? 1 : 0;
  });
  std::jthread servo([&](std::stop_token stop) {
    while (!stop.stop_requested()) {
      if (const auto state = bench->robot().read()) static_cast<void>(bench->robot().command({state->q_rad}));
      static_cast<void>(bench->truthAt(steady.now()));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  });
  cameras.join();
  EXPECT_EQ(frames, 5);
}

TEST_F(BenchTest, MovesARealRecording) {
  settings_.motion = std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc";
  if (!std::filesystem::exists(settings_.motion)) GTEST_SKIP() << settings_.motion << " is absent";
  const auto bench = make();
  bench->setPatientMoving(true);
  for (int i = 0; i < 4; ++i) {
    const auto frame = run(*bench, 0.4);
    const auto truth = bench->truthAt(frame->exposed_at);
    const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
    for (const auto& disc : truth.discs)
      EXPECT_GT(brightnessAt(frame->left, *bench->rig().left.project(X_CB * disc.p_B)), 40.0);
  }
}

TEST_F(BenchTest, RefusesWhatItCannotBuildOn) {
  settings_.resources = "/nowhere";
  EXPECT_FALSE(Bench::make(settings_, time_));
  settings_.resources = RESOURCES;
  settings_.motion = "/nowhere/markers.trc";
  EXPECT_EQ(Bench::make(settings_, time_).error().file, settings_.motion);
}

TEST_F(BenchTest, APlateStandsInPlaceOfThePatient) {
  Disc disc;
  disc.normal_B = -Eigen::Vector3d::UnitZ();
  disc.diameter_m = 0.012;
  settings_.plate = Plate{{patchOf(disc)}, bench_layout::plateX_BP()};
  const auto bench = make();
  const auto frame = run(*bench, 0.2);
  ASSERT_TRUE(frame);
  const auto truth = bench->truthAt(frame->exposed_at);
  EXPECT_TRUE(truth.discs.empty());
  const Eigen::Vector3d p_C = (truth.X_BF * bench->X_FC()).inverse() * settings_.plate->X_BM.translation();
  EXPECT_GT(brightnessAt(frame->left, *bench->rig().left.project(p_C)), 100.0);
  EXPECT_GT(brightnessAt(frame->right, *bench->rig().right.project(bench->rig().X_RC * p_C)), 100.0);
  bench->hideTarget(true);
  const auto without = run(*bench, 0.2);
  ASSERT_TRUE(without);
  EXPECT_LT(brightnessAt(without->left, *bench->rig().left.project(p_C)), 50.0);
}

TEST_F(BenchTest, ACameraClockMayRunAhead) {
  const auto right = run(*make(), 0.2);
  time_.set(fromNanoseconds(1'000'000'000));
  settings_.camera_clock_ahead = Seconds(0.007);
  const auto ahead = run(*make(), 0.2);
  ASSERT_TRUE(right && ahead);
  EXPECT_EQ(ahead->sequence, right->sequence);
  EXPECT_NEAR(secondsBetween(right->exposed_at, ahead->exposed_at), 0.007, 1e-6);
}

}  // namespace
}  // namespace mirrorarm::simulation
