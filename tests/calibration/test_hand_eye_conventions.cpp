#include <gtest/gtest.h>

#include "core/calibration/hand_eye.h"
#include "tests/calibration/stations.h"

namespace mirrorarm::calibration {
namespace {

StationMaker makerFor(CameraMount mount, unsigned seed) {
  StationMaker maker;
  maker.noise_m = 0.0003;
  maker.noise_deg = 0.03;
  maker.random.seed(seed);
  if (mount == CameraMount::kToHand) {
    maker.X_FC = makeTransform(
        Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Eigen::Vector3d(0.3, -0.8, 0.2).normalized())),
        Eigen::Vector3d(0.9, -0.5, 0.8));
    maker.X_BM = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX())),
                               Eigen::Vector3d(0.05, 0.02, 0.12));
  }
  return maker;
}

/// Stations as a camera so mounted gives them.
std::vector<PosePair> stationsOf(CameraMount mount, int count, unsigned seed) {
  StationMaker maker = makerFor(mount, seed);
  return mount == CameraMount::kInHand ? maker.stations(count) : maker.stationsToHand(count);
}

RigidTransform scalarFirst(const RigidTransform& X) {
  const auto q = rotationOf(X);
  return makeTransform(Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()), X.translation());
}

template <class Spoil>
std::string refusalOf(CameraMount taken, CameraMount given, int count, unsigned seed, Spoil spoil) {
  auto stations = stationsOf(given, count, seed);
  for (auto& station : stations) spoil(station);
  const auto found = solveHandEye(stations, taken);
  return found ? "solved" : reason(found.error());
}

void invertRobot(PosePair& pair) { pair.X_BF = pair.X_BF.inverse(); }
void invertCamera(PosePair& pair) { pair.X_CM = pair.X_CM.inverse(); }
void invertBoth(PosePair& pair) {
  invertRobot(pair);
  invertCamera(pair);
}
void leave(PosePair&) {}

constexpr auto kInHand = CameraMount::kInHand;
constexpr auto kToHand = CameraMount::kToHand;

TEST(HandEyeConvention, InvertedPosesAreNamedNeverSolved) {
  for (const auto mount : {kInHand, kToHand})
    for (const int count : {4, 8, 15})
      for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(std::string(name(mount)) + " " + std::to_string(count) + " seed " +
                     std::to_string(seed));
        EXPECT_EQ(refusalOf(mount, mount, count, seed, invertRobot), reason(HandEyeError::kRobotInverted));
        EXPECT_EQ(refusalOf(mount, mount, count, seed, invertCamera), reason(HandEyeError::kCameraInverted));
        EXPECT_EQ(refusalOf(mount, mount, count, seed, invertBoth), reason(HandEyeError::kBothInverted));
        EXPECT_EQ(refusalOf(mount, mount, count, seed, leave), "solved");
      }
}

TEST(HandEyeConvention, ACameraElsewhereIsNamed) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    EXPECT_EQ(refusalOf(kInHand, kToHand, 15, seed, leave), reason(HandEyeError::kCameraBesideRobot));
    EXPECT_EQ(refusalOf(kToHand, kInHand, 15, seed, leave), reason(HandEyeError::kCameraInHand));
  }
}

TEST(HandEyeConvention, QuaternionsWrittenScalarFirstAreNamed) {
  const auto robot = [](PosePair& pair) { pair.X_BF = scalarFirst(pair.X_BF); };
  const auto camera = [](PosePair& pair) { pair.X_CM = scalarFirst(pair.X_CM); };
  const auto both = [](PosePair& pair) {
    pair.X_BF = scalarFirst(pair.X_BF);
    pair.X_CM = scalarFirst(pair.X_CM);
  };
  for (unsigned seed = 0; seed < 8; ++seed) {
    EXPECT_EQ(refusalOf(kInHand, kInHand, 15, seed, robot), reason(HandEyeError::kRobotScalarFirst));
    EXPECT_EQ(refusalOf(kInHand, kInHand, 15, seed, camera), reason(HandEyeError::kCameraScalarFirst));
    EXPECT_EQ(refusalOf(kInHand, kInHand, 15, seed, both), reason(HandEyeError::kBothScalarFirst));
  }
}

TEST(HandEyeConvention, MillimetresAreNamed) {
  const auto robot = [](PosePair& pair) { pair.X_BF.translation() *= 1e3; };
  const auto camera = [](PosePair& pair) { pair.X_CM.translation() *= 1e3; };
  EXPECT_EQ(refusalOf(kInHand, kInHand, 15, 1, robot), reason(HandEyeError::kRobotInMillimetres));
  EXPECT_EQ(refusalOf(kInHand, kInHand, 15, 1, camera), reason(HandEyeError::kCameraInMillimetres));
}

/// The board of 8 by 5 squares of 25 mm seen from its other end.
RigidTransform otherEnd() {
  RigidTransform half_turn = RigidTransform::Identity();
  half_turn.linear().diagonal() << -1.0, -1.0, 1.0;
  half_turn.translation() = Eigen::Vector3d(0.2, 0.125, 0.0);
  return half_turn;
}

TEST(HandEyeConvention, BoardsSeenHalfATurnRoundAreTurnedBack) {
  for (const std::vector<std::size_t>& turned :
       {std::vector<std::size_t>{4}, std::vector<std::size_t>{0, 3, 5, 8, 9, 12, 14}})
    for (unsigned seed = 0; seed < 8; ++seed) {
      StationMaker maker = makerFor(kInHand, seed);
      auto stations = maker.stations(15);
      for (const auto station : turned) stations[station].X_CM = stations[station].X_CM * otherEnd();
      const auto found = solveHandEye(stations, kInHand);
      ASSERT_TRUE(found) << reason(found.error());
      EXPECT_EQ(found->turned, turned);
      EXPECT_TRUE(found->outliers.empty());
      EXPECT_LT((found->X_PC.translation() - maker.X_FC.translation()).norm(), 0.0015);
    }
}

TEST(HandEyeConvention, TooFewBoardsTheRightWayRoundAreRefusedByName) {
  StationMaker maker = makerFor(kInHand, 2);
  auto stations = maker.stations(5);
  for (const auto station : {1, 4}) stations[station].X_CM = stations[station].X_CM * otherEnd();
  const auto found = solveHandEye(stations, kInHand);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().error, HandEyeError::kBoardTurned);
  EXPECT_EQ(found.error().stations, (std::vector<std::size_t>{1, 4}));
  EXPECT_NE(reason(found.error()).find("stations 1, 4"), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::calibration
