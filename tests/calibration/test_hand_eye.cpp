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
  EXPECT_LT(std::sqrt(squares), 0.0006);
  EXPECT_GT(std::sqrt(sigma_squares), 0.4 * std::sqrt(squares));  // the worst of three axes
  EXPECT_LT(std::sqrt(sigma_squares), 1.2 * std::sqrt(squares));
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

/// Spoils stations of many clean sets: what is named and what error is left.
template <class Spoil>
double rmsWithOutliers_m(const std::vector<std::size_t>& spoilt, Spoil spoil) {
  constexpr int kRuns = 40;
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    StationMaker maker = noisyMaker();
    maker.random.seed(static_cast<unsigned>(100 + run));
    auto stations = maker.stations(15);
    for (const auto station : spoilt) spoil(stations[station], maker.normal3().normalized().eval());
    const auto found = solveHandEye(stations, CameraMount::kInHand);
    EXPECT_TRUE(found) << "run " << run;
    if (!found) continue;
    EXPECT_EQ(found->outliers, spoilt) << "run " << run;
    for (const auto station : spoilt) EXPECT_TRUE(found->stations[station].is_outlier);
    squares += std::pow(distance_m(found->X_PC, maker.X_FC), 2) / kRuns;
  }
  return std::sqrt(squares);
}

TEST(HandEye, OneStationFiftyMillimetresOffIsNamedInEveryRun) {
  const auto shift = [](PosePair& pair, const Eigen::Vector3d& way) {
    pair.X_CM.translation() += 0.05 * way;
  };
  EXPECT_LT(rmsWithOutliers_m({6}, shift), 0.0006);
  EXPECT_LT(rmsWithOutliers_m({6, 9}, shift), 0.0006);
}

TEST(HandEye, OneStationTurnedIsNamedInEveryRun) {
  const auto turn = [](PosePair& pair, const Eigen::Vector3d& way) {
    pair.X_CM.rotate(Eigen::AngleAxisd(0.02, way));
  };
  EXPECT_LT(rmsWithOutliers_m({6}, turn), 0.0006);
  const auto robot = [](PosePair& pair, const Eigen::Vector3d& way) {
    pair.X_BF.rotate(Eigen::AngleAxisd(0.5, way));
  };
  EXPECT_LT(rmsWithOutliers_m({3, 11}, robot), 0.0006);
}

TEST(HandEye, CleanSetsOfAnySizeNameNothing) {
  int named = 0;
  for (const int count : {3, 4, 5, 6, 8, 15, 30})
    for (unsigned run = 0; run < 20; ++run) {
      StationMaker maker = noisyMaker();
      maker.random.seed(run);
      const auto found = solveHandEye(maker.stations(count), CameraMount::kInHand);
      if (found && !found->outliers.empty()) ++named;
    }
  EXPECT_LE(named, 1);  // 2 of 1000
}

TEST(HandEye, RefinedIsBetterThanClosedFormWhereTheBoardsOwnPoseErrs) {
  double refined = 0.0, closed = 0.0, told = 0.0;
  for (unsigned run = 0; run < 30; ++run) {
    StationMaker maker = noisyMaker();
    maker.random.seed(run);
    auto stations = maker.stations(15);
    for (auto& station : stations)
      station.X_CM = maker.X_FC.inverse() * station.X_BF.inverse() * maker.X_BM * maker.noise();
    const auto best = solveHandEye(stations, CameraMount::kInHand);
    const auto park = solveHandEye(stations, CameraMount::kInHand, HandEyeMethod::kParkMartin);
    ASSERT_TRUE(best && park);
    ASSERT_TRUE(best->covariance);
    EXPECT_FALSE(park->covariance);
    refined += std::pow(distance_m(best->X_PC, maker.X_FC), 2);
    closed += std::pow(distance_m(park->X_PC, maker.X_FC), 2);
    told += best->covariance->bottomRightCorner<3, 3>().trace();
  }
  EXPECT_LT(refined, closed);
  EXPECT_NEAR(std::sqrt(told / refined), 1.0, 0.3);
}

TEST(HandEye, AllMethodsAgreeAndSayWhichTheyAre) {
  StationMaker maker = noisyMaker();
  const auto stations = maker.stations(15);
  for (const auto method : {HandEyeMethod::kTsaiLenzVisp, HandEyeMethod::kTsaiLenzAllPairs,
                            HandEyeMethod::kParkMartin, HandEyeMethod::kRefined}) {
    const auto found = solveHandEye(stations, CameraMount::kInHand, method);
    ASSERT_TRUE(found) << name(method);
    EXPECT_EQ(found->method, method);
    EXPECT_LT(distance_m(found->X_PC, maker.X_FC), 0.0015) << name(method);
    EXPECT_TRUE(found->sigma_m);
    EXPECT_EQ(found->stations.size(), 15u);
  }
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
