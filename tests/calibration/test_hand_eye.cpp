#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "core/calibration/hand_eye.h"
#include "core/calibration/tsai_lenz.h"
#include "tests/calibration/stations.h"

namespace mirrorarm::calibration {
namespace {

double distance_m(const RigidTransform& a, const RigidTransform& b) {
  return (a.translation() - b.translation()).norm();
}

StationMaker noisyMaker() {
  StationMaker maker;
  maker.noise_m = 0.0003;
  maker.noise_deg = 0.03;
  return maker;
}

TEST(HandEye, FindsTheTruthExactlyWithoutNoise) {
  StationMaker maker;
  const auto found = solveHandEye(maker.stations(8), CameraMount::kInHand);
  ASSERT_TRUE(found);
  EXPECT_LT(distance_m(found->X_PC, maker.X_FC), 1e-7);
  EXPECT_LT(angleBetween(found->X_PC, maker.X_FC), 1e-7);
  EXPECT_LT(distance_m(found->X_QM, maker.X_BM), 1e-7);
  EXPECT_TRUE(found->outliers.empty());
}

TEST(HandEye, ErrorStaysWithinTheNoiseAndSigmaTellsIt) {
  double squares = 0.0, sigma_squares = 0.0;
  constexpr int kRuns = 20;
  StationMaker maker = noisyMaker();
  for (int run = 0; run < kRuns; ++run) {
    const auto found = solveHandEye(maker.stations(15), CameraMount::kInHand);
    ASSERT_TRUE(found);
    squares += std::pow(distance_m(found->X_PC, maker.X_FC), 2) / kRuns;
    ASSERT_TRUE(found->sigma_m);
    sigma_squares += std::pow(*found->sigma_m, 2) / kRuns;
  }
  EXPECT_LT(std::sqrt(squares), 0.0008);  // 0.52 mm rms is what these turns allow
  EXPECT_GT(std::sqrt(sigma_squares), 0.4 * std::sqrt(squares));
  EXPECT_LT(std::sqrt(sigma_squares), 2.0 * std::sqrt(squares));
}

TEST(HandEye, CameraBesideTheRobot) {
  StationMaker maker = noisyMaker();
  maker.X_FC =
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Eigen::Vector3d(0.3, -0.8, 0.2).normalized())),
                    Eigen::Vector3d(0.66, -0.25, 0.83));
  const auto found = solveHandEye(maker.stationsToHand(15), CameraMount::kToHand);
  ASSERT_TRUE(found);
  EXPECT_LT(distance_m(found->X_PC, maker.X_FC), 0.002);
}

TEST(HandEye, OneStationFiftyMillimetresOffIsNamedAndLeftOut) {
  StationMaker maker = noisyMaker();
  auto stations = maker.stations(15);
  stations[6].X_CM.translation() += Eigen::Vector3d(0.05, 0.0, 0.0);
  const auto found = solveHandEye(stations, CameraMount::kInHand);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outliers, std::vector<std::size_t>{6});
  EXPECT_LT(distance_m(found->X_PC, maker.X_FC), 0.0015);
}

TEST(HandEye, ThreeWrongStationsOfFifteenAreNamed) {
  StationMaker maker = noisyMaker();
  auto stations = maker.stations(15);
  stations[1].X_CM.translation() += Eigen::Vector3d(0.0, 0.02, 0.0);
  stations[8].X_BF = stations[9].X_BF;  // a stale flange pose
  stations[14].X_CM.rotate(
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));  // board order flipped
  const auto found = solveHandEye(stations, CameraMount::kInHand);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outliers, (std::vector<std::size_t>{1, 8}));
  EXPECT_EQ(found->turned, std::vector<std::size_t>{14});
}

TEST(HandEye, AllPairsSolveACameraTurnedByHalfATurn) {
  for (const auto& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 2, 3)}) {
    StationMaker maker;
    maker.X_FC.linear() = Eigen::AngleAxisd(std::numbers::pi, axis.normalized()).toRotationMatrix();
    const auto X_FC = tsaiLenzOverAllPairs(maker.stations(6));
    ASSERT_TRUE(X_FC);
    EXPECT_LT(distance_m(*X_FC, maker.X_FC), 1e-7);
    EXPECT_LT(angleBetween(*X_FC, maker.X_FC), 1e-7);
  }
}

TEST(HandEye, RefusesWhatCannotDetermineTheCamera) {
  StationMaker maker = noisyMaker();
  const auto refusal = [](const std::vector<PosePair>& stations) {
    const auto found = solveHandEye(stations, CameraMount::kInHand);
    return found ? std::optional<HandEyeError>() : found.error().error;
  };
  EXPECT_EQ(refusal({}), HandEyeError::kTooFewPairs);
  EXPECT_EQ(refusal(maker.stations(2)), HandEyeError::kTooFewPairs);
  EXPECT_EQ(refusal(maker.stationsAboutOneAxis(12)), HandEyeError::kOneAxis);
  EXPECT_EQ(refusal(std::vector<PosePair>(5, maker.station(Eigen::Vector3d::UnitX()))),
            HandEyeError::kTurnsTooSmall);
  maker.smallest_turn_deg = maker.largest_turn_deg = 3.0;
  EXPECT_EQ(refusal(maker.stations(3)), HandEyeError::kTurnsTooSmall);
}

TEST(HandEye, RefusesPosesThatAreNone) {
  StationMaker maker;
  auto stations = maker.stations(5);
  stations[3].X_CM.translation().y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solveHandEye(stations, CameraMount::kInHand).error().error, HandEyeError::kNotRigid);
  stations = maker.stations(5);
  stations[0].X_BF.linear() *= 1.1;
  EXPECT_EQ(solveHandEye(stations, CameraMount::kInHand).error().error, HandEyeError::kNotRigid);
}

TEST(HandEye, VispPrintsNothing) {
  StationMaker maker;
  testing::internal::CaptureStdout();
  EXPECT_TRUE(tsaiLenzByVisp(maker.stations(6)));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(HandEye, NamesGoThereAndBack) {
  EXPECT_EQ(cameraMountOf("in-hand"), CameraMount::kInHand);
  EXPECT_EQ(cameraMountOf("to-hand"), CameraMount::kToHand);
  EXPECT_EQ(cameraMountOf("elsewhere"), std::nullopt);
}

}  // namespace
}  // namespace mirrorarm::calibration
