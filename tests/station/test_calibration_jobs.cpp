#include <numbers>

#include "tests/station/bench_calibration.h"

namespace mirrorarm::station {
namespace {

using camera::LensModel;

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(CalibrationJobs, StereoFromAWrongDataSheet) {
  BenchCalibration bench({.settings = {.stereo_views = 6}, .change = [](Equipment& equipment) {
                            equipment.rig = roughRig(equipment.rig, 1.01, 0.001);
                          }});
  ASSERT_EQ(bench.begin(CalibrationJob::kStereo, LensModel::kKannalaBrandt), CalibrationAnswer::kAccepted);
  ASSERT_TRUE(bench.driveToTheEnd());
  ASSERT_EQ(bench.seen().views->size(), 6u);
  const auto outcome = bench.solve();
  ASSERT_TRUE(outcome) << bench.seen().refusal;
  const auto& result = std::get<StereoOutcome>(*outcome).result;
  const auto& truth = bench.bench().rig();
  EXPECT_LT(result.rms_px, 0.06);
  EXPECT_NEAR(result.rig.left.intrinsics().fx_px / truth.left.intrinsics().fx_px, 1.0, 1e-3);
  EXPECT_NEAR(result.rig.X_RC.translation().norm(), truth.X_RC.translation().norm(), 1e-4);
  EXPECT_LT(angleBetween(result.rig.X_RC, truth.X_RC), 0.02 * kDegree);

  ASSERT_EQ(bench.ask({.action = CalibrationAction::kAccept}), CalibrationAnswer::kAccepted);
  EXPECT_EQ(bench.seen().phase, CalibrationPhase::kAccepted);
  ASSERT_TRUE(bench.inForce().rig);
  EXPECT_FALSE(bench.inForce().rig->calibration.date.empty());
  const auto record = bench.folder().path() / "records" / bench.seen().record;
  EXPECT_TRUE(std::filesystem::exists(record / "left_01.png"));
  EXPECT_TRUE(std::filesystem::exists(record / "right_06.png"));
}

TEST(CalibrationJobs, HandEyeFromARoughPlace) {
  BenchCalibration bench({.settings = {.hand_eye_stations = 5},
                          .change =
                              [](Equipment& equipment) {
                                equipment.X_FC.translation() += Eigen::Vector3d(0.002, -0.001, 0.002);
                                equipment.X_FC.rotate(Eigen::AngleAxisd(kDegree, Eigen::Vector3d::UnitX()));
                              },
                          .before = [](calibration::InForce& in_force) { in_force.hand_eye.reset(); }});
  ASSERT_EQ(bench.begin(CalibrationJob::kHandEye), CalibrationAnswer::kAccepted);
  ASSERT_TRUE(bench.driveToTheEnd());
  ASSERT_EQ(bench.seen().views->size(), 5u);
  const auto outcome = bench.solve();
  ASSERT_TRUE(outcome) << bench.seen().refusal;
  const auto& result = std::get<HandEyeOutcome>(*outcome).result;
  const auto& truth = bench.bench().X_FC();
  EXPECT_LT((result.X_PC.translation() - truth.translation()).norm(), 1e-4);
  EXPECT_LT(angleBetween(result.X_PC, truth), 0.01 * kDegree);
  EXPECT_TRUE(bench.seen().views->front().residual_m);
  ASSERT_EQ(bench.ask({.action = CalibrationAction::kAccept}), CalibrationAnswer::kAccepted);
  EXPECT_TRUE(bench.inForce().hand_eye);
  const auto pairs =
      calibration::readPosePairs(bench.folder().path() / "records" / bench.seen().record / "pose_pairs.csv");
  ASSERT_TRUE(pairs) << describe(pairs.error());
  EXPECT_EQ(pairs->size(), bench.seen().views->size());
}

TEST(CalibrationJobs, ClockOffsetBelowTheFrameInterval) {
  auto settings = benchWithPlate();
  settings.rate_hz = 12.0;
  settings.camera_clock_ahead = Seconds(0.007);
  BenchCalibration bench({.bench = settings, .before = truthInForce});
  ASSERT_EQ(bench.begin(CalibrationJob::kClock), CalibrationAnswer::kAccepted);
  ASSERT_TRUE(bench.driveToTheEnd());
  EXPECT_EQ(bench.seen().progress, 1.0);
  const auto outcome = bench.solve();
  ASSERT_TRUE(outcome) << bench.seen().refusal;
  const auto& result = std::get<ClockOutcome>(*outcome).result;
  EXPECT_NEAR(result.offset_s, -0.007, 1e-3);
  EXPECT_GT(result.correlation, 0.9);
  ASSERT_EQ(bench.ask({.action = CalibrationAction::kAccept}), CalibrationAnswer::kAccepted);
  ASSERT_TRUE(bench.inForce().clock);
  EXPECT_NEAR(bench.inForce().clock->offset_s, -0.007, 1e-3);
}

CalibrationSettings smallGrid() { return {.drift_stations = {2, 2, 2}}; }

TEST(CalibrationJobs, DriftHoldsWhereNothingMoved) {
  BenchCalibration bench({.settings = smallGrid(), .before = truthInForce});
  ASSERT_EQ(bench.begin(CalibrationJob::kDrift), CalibrationAnswer::kAccepted);
  ASSERT_TRUE(bench.driveToTheEnd());
  ASSERT_EQ(bench.seen().views->size(), 8u);
  const auto outcome = bench.solve();
  ASSERT_TRUE(outcome) << bench.seen().refusal;
  const auto& findings = std::get<DriftOutcome>(*outcome).findings;
  EXPECT_EQ(findings.verdict, calibration::DriftVerdict::kHolds);
  ASSERT_TRUE(findings.grid);
  EXPECT_EQ(findings.grid->stations, 8u);
  EXPECT_LT(findings.grid->std_mm.maxCoeff(), 0.1);
  ASSERT_EQ(bench.ask({.action = CalibrationAction::kAccept}), CalibrationAnswer::kAccepted);
  EXPECT_TRUE(bench.inForce().drift);
}

TEST(CalibrationJobs, DriftFailsWhereACameraWasKnocked) {
  BenchCalibration bench({.before = [](calibration::InForce& in_force) {
    in_force.rig->X_RC.rotate(Eigen::AngleAxisd(0.2 * kDegree, Eigen::Vector3d::UnitX()));
  }});
  ASSERT_EQ(bench.begin(CalibrationJob::kDrift), CalibrationAnswer::kAccepted);
  ASSERT_EQ(bench.seen().views->size(), 1u);  // one view says enough
  const auto outcome = bench.solve();
  ASSERT_TRUE(outcome) << bench.seen().refusal;
  EXPECT_EQ(std::get<DriftOutcome>(*outcome).findings.verdict, calibration::DriftVerdict::kFailed);
}

}  // namespace
}  // namespace mirrorarm::station
