#include <numbers>

#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "tests/ui/fake_calibration.h"
#include "ui/model/calibration_result.h"
#include "ui/model/readiness.h"
#include "ui/model/standing_lines.h"
#include "ui/model/view_guidance.h"

namespace mirrorarm::ui {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const Eigen::Vector3d kUpright = Eigen::Vector3d::Zero();
const RigidTransform kNow = test::plateAt(0.4);

QString guided(const RigidTransform& wish, Moved moved) {
  return guidanceTo(wish, kNow, test::dotPlate(), moved).join(QLatin1Char(' '));
}

TEST(ViewGuidance, IsSilentWhereTheViewIsNearEnough) {
  EXPECT_TRUE(guidanceTo(kNow, kNow, test::dotPlate(), Moved::kBoard).isEmpty());
  EXPECT_TRUE(guided(test::plateAt(0.42, {3 * kDegree, 0, 0}), Moved::kBoard).isEmpty());
}

TEST(ViewGuidance, SaysEachWayToMoveTheBoard) {
  using Case = std::pair<RigidTransform, const char*>;
  for (const auto& [wish, text] :
       {Case{test::plateAt(0.30), "Bring the board 10 cm nearer."},
        Case{test::plateAt(0.55), "Take the board 15 cm farther away."},
        Case{test::plateAt(0.4, kUpright, {0.05, 0, 0}), "Move it 5 cm to the right in the image."},
        Case{test::plateAt(0.4, kUpright, {-0.05, 0, 0}), "Move it 5 cm to the left in the image."},
        Case{test::plateAt(0.4, kUpright, {0, 0.04, 0}), "Move it 4 cm down in the image."},
        Case{test::plateAt(0.4, {20 * kDegree, 0, 0}), "Tilt its upper edge 20° towards the cameras."},
        Case{test::plateAt(0.4, {0, -30 * kDegree, 0}), "Tilt its left edge 30° towards the cameras."},
        Case{test::plateAt(0.4, {0, 0, 45 * kDegree}), "Turn it 45° clockwise in the image."}})
    EXPECT_EQ(guided(wish, Moved::kBoard).toStdString(), text);
}

// An edge that comes nearer in the words must come nearer in the world.
TEST(ViewGuidance, TheSignsAreThoseOfTheWorld) {
  const auto points_M = calibration::boardPoints(test::dotPlate());
  const auto depthOf = [&points_M](const RigidTransform& X_CM, std::size_t point) {
    return (X_CM * points_M[point]).z();
  };
  constexpr std::size_t kUpperMiddle = 4, kRightMiddle = 35;
  const auto upper = test::plateAt(0.4, {20 * kDegree, 0, 0});
  EXPECT_LT(depthOf(upper, kUpperMiddle), depthOf(kNow, kUpperMiddle));
  const auto left = test::plateAt(0.4, {0, -30 * kDegree, 0});
  EXPECT_GT(depthOf(left, kRightMiddle), depthOf(kNow, kRightMiddle));
  const auto clockwise = test::plateAt(0.4, {0, 0, 45 * kDegree});
  EXPECT_GT((clockwise * points_M[kRightMiddle]).y(), (kNow * points_M[kRightMiddle]).y())
      << "the right edge goes down, y points down";
}

TEST(ViewGuidance, MovesTheCamerasTheOtherWay) {
  EXPECT_EQ(guided(test::plateAt(0.4, kUpright, {0.05, 0, 0}), Moved::kCameras).toStdString(),
            "Move the cameras 5 cm to the left.");
  EXPECT_EQ(guided(test::plateAt(0.4, {0, 0, 45 * kDegree}), Moved::kCameras).toStdString(),
            "Turn the cameras 45° counter-clockwise.");
}

// The board lies at the origin of the world; what the words say is done to the cameras.
TEST(ViewGuidance, SwingingTheCamerasShowsTheSideTheySwingTo) {
  const auto wish = test::plateAt(0.4, {0, 30 * kDegree, 0});
  EXPECT_EQ(guided(wish, Moved::kCameras).toStdString(),
            "Swing the cameras 30° to the right around the board.");
  const Eigen::Vector3d before = kNow.inverse().translation();
  const Eigen::Vector3d after = wish.inverse().translation();
  EXPECT_GT(after.x(), before.x() + 0.1) << "the plate's x is the image's right";
}

TEST(ViewGuidance, SaysTheLargestDifferencesFirstAndNotMoreThanThree) {
  const auto wish = test::plateAt(0.55, {10 * kDegree, 40 * kDegree, 0}, {0.06, 0.05, 0});
  const auto sentences = guidanceTo(wish, kNow, test::dotPlate(), Moved::kBoard);
  ASSERT_EQ(sentences.size(), 3);
  EXPECT_TRUE(sentences[0].contains(QStringLiteral("40°"))) << sentences[0].toStdString();
  EXPECT_TRUE(sentences[1].contains(QStringLiteral("15 cm"))) << sentences[1].toStdString();
}

TEST(Standing, EachIsToldByLightAndAge) {
  using calibration::Standing;
  const auto line = [](Standing standing, std::chrono::minutes age) {
    return standingLine({standing, "2026-11-19", age});
  };
  EXPECT_EQ(line(Standing::kValid, std::chrono::hours(72)).text, QStringLiteral("in force, 3 days old"));
  EXPECT_EQ(line(Standing::kValid, std::chrono::minutes(20)).text, QStringLiteral("in force, 20 min old"));
  EXPECT_EQ(line(Standing::kExpired, std::chrono::hours(100 * 24)).light, Light::kBad);
  EXPECT_EQ(line(Standing::kDoubtful, std::chrono::hours(5)).light, Light::kWaiting);
  EXPECT_EQ(line(Standing::kMissing, {}).light, Light::kOff);
}

TEST(Standing, ReadinessNamesWhatDoesNotHold) {
  auto workplace = test::benchWorkplace();
  workplace.calibrations = calibration::Validity{};
  auto& status = workplace.calibrations->status;
  status[0] = {calibration::Standing::kValid, "2026-11-19", std::chrono::hours(72)};
  status[1] = {calibration::Standing::kExpired, "2026-07-01", std::chrono::hours(140 * 24)};
  QStringList wrong, right;
  for (const auto& check : readinessOf({}, workplace, Clock::now()))
    (check.passed ? right : wrong) << check.text;
  EXPECT_TRUE(right.contains(QStringLiteral("Stereo cameras: in force, 3 days old")));
  EXPECT_TRUE(wrong.contains(QStringLiteral("Hand-eye: expired, 140 days old")));
  EXPECT_TRUE(wrong.contains(QStringLiteral("Calibrations not checked today")));
  EXPECT_FALSE(wrong.join(QString()).contains(QStringLiteral("Clock"))) << "none is needed";
}

const ResultRow* rowOf(const CalibrationResult& result, const char* figure) {
  for (const auto& row : result.rows)
    if (row.figure.startsWith(QLatin1String(figure))) return &row;
  return nullptr;
}

class Results : public ::testing::Test {
 protected:
  station::StereoOutcome stereo_ = test::stereoOutcome(test::benchWorkplace().rig);
};

TEST_F(Results, AGoodStereoCalibrationIsGreenWithItsFigures) {
  const auto result = resultOf(stereo_);
  EXPECT_EQ(result.light, Light::kGood);
  EXPECT_EQ(rowOf(result, "Each of 18 views kept out")->is_heading, true);
  EXPECT_EQ(rowOf(result, "Distance from the epipolar line")->value, QStringLiteral("0.031 px"));
  EXPECT_EQ(rowOf(result, "Distance from the epipolar line")->limit, QStringLiteral("≤ 0.150 px"));
  EXPECT_EQ(rowOf(result, "Depth")->value, QStringLiteral("0.071 mm"));
  EXPECT_EQ(rowOf(result, "Views left out")->value, QStringLiteral("view-07, view-12"));
  EXPECT_EQ(rowOf(result, "Distance from the epipolar line, same views")->in_force,
            QStringLiteral("0.187 px"));
  EXPECT_EQ(rowOf(result, "Depth at 0.6 m")->value, QStringLiteral("0.15 %"));
  EXPECT_EQ(rowOf(result, "Lens model")->value, QStringLiteral("Brown-Conrady"));
}

TEST_F(Results, BeyondTheLimitIsAmberAndBeyondTwiceRed) {
  stereo_.result.hold_out->epipolar_px = 0.25;
  EXPECT_EQ(resultOf(stereo_).light, Light::kWaiting);
  stereo_.result.hold_out->square_mean_percent = -0.6;
  const auto result = resultOf(stereo_);
  EXPECT_EQ(result.light, Light::kBad) << "a negative error is an error";
  EXPECT_EQ(rowOf(result, "Lengths on the board, mean")->light, Light::kBad);
}

TEST_F(Results, WhatIsNoNumberIsRed) {
  stereo_.result.rms_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(resultOf(stereo_).light, Light::kBad);
}

TEST_F(Results, ABentBoardIsNamedWithTheRemedy) {
  stereo_.result.board_shape->is_bent = true;
  const auto result = resultOf(stereo_);
  EXPECT_EQ(result.light, Light::kWaiting);
  EXPECT_NE(rowOf(result, "Bent: replace it"), nullptr);
}

TEST_F(Results, WithoutOneInForceThereIsNoComparison) {
  stereo_.against_in_force.reset();
  EXPECT_EQ(rowOf(resultOf(stereo_), "Against"), nullptr);
}

TEST_F(Results, HandEyeCountsWhatItLeftOut) {
  station::HandEyeOutcome outcome;
  outcome.result.rms_m = 0.0002;
  outcome.result.rms_rad = 0.0004;
  outcome.result.sigma_m = 0.00004;
  outcome.result.stations.resize(12);
  outcome.result.outliers = {4};
  outcome.shift_mm = 0.7;
  outcome.turn_deg = 0.02;
  const auto result = resultOf(outcome);
  EXPECT_EQ(result.light, Light::kWaiting);
  EXPECT_EQ(rowOf(result, "Views left out")->value, QStringLiteral("1 of 12"));
  EXPECT_EQ(rowOf(result, "Shifted by")->value, QStringLiteral("0.70 mm"));
  EXPECT_NE(rowOf(result, "How far the board strays over 11 views"), nullptr);
}

TEST_F(Results, TheClockIsJudgedByItsUncertaintyAndTheAgreement) {
  station::ClockOutcome outcome;
  outcome.result.offset_s = 0.0407;
  outcome.result.sigma_s = 0.0004;
  outcome.result.correlation = 0.9;
  const auto result = resultOf(outcome);
  EXPECT_EQ(result.light, Light::kWaiting) << "the movements agree poorly";
  EXPECT_EQ(rowOf(result, "Offset")->value, QStringLiteral("40.70 ms"));
}

TEST_F(Results, TheDriftCheckSaysWhatToDo) {
  station::DriftOutcome outcome;
  outcome.findings.epipolar_px = 0.05;
  outcome.findings.grid = calibration::DriftFindings::Grid{{0.1, 0.2, 0.5}, 0.1, 27};
  outcome.findings.verdict = calibration::DriftVerdict::kDoubtful;
  const auto result = resultOf(outcome);
  EXPECT_EQ(result.light, Light::kWaiting);
  EXPECT_TRUE(result.verdict.contains(QStringLiteral("calibrate soon")));
  EXPECT_EQ(rowOf(result, "Place of the board along z")->light, Light::kWaiting);
}

}  // namespace
}  // namespace mirrorarm::ui
