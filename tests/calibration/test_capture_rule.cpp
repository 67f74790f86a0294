#include <gtest/gtest.h>

#include "core/calibration/capture_rule.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

constexpr ImageSize kSize{1296, 964};

class Capture : public testing::Test {
 protected:
  /// The board as both cameras see it, with the noise of a still sensor.
  BoardView seenAt(const RigidTransform& X_CM) {
    BoardView view;
    EXPECT_TRUE(maker_.see(maker_.rig.left, X_CM, view.seen[0]));
    EXPECT_TRUE(maker_.see(maker_.rig.right, maker_.rig.X_RC * X_CM, view.seen[1]));
    return view;
  }
  static RigidTransform at(double x, double z, double turn_rad = 0.0) {
    const Eigen::Quaterniond R(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()));
    return makeTransform(R, Eigen::Vector3d(x, -0.06, z) - R * Eigen::Vector3d(0.1, 0.0, 0.0));
  }
  /// The verdict after some frames in one place.
  CaptureVerdict heldAt(const RigidTransform& X_CM, int frames = 6) {
    CaptureVerdict verdict = CaptureVerdict::kNoBoard;
    for (int i = 0; i < frames; ++i) verdict = rule_.judge(seenAt(X_CM), taken_);
    return verdict;
  }

  ViewMaker maker_{trueRig(camera::LensModel::kBrownConrady), {BoardKind::kChessboard, 9, 6, 0.025}, 0.05};
  CaptureRule rule_{maker_.board, kSize, true};
  std::vector<BoardView> taken_;
};

TEST_F(Capture, WaitsUntilTheBoardIsStill) {
  EXPECT_EQ(rule_.judge(seenAt(at(0.05, 0.45)), taken_), CaptureVerdict::kMoving);
  EXPECT_EQ(rule_.judge(seenAt(at(0.05, 0.45)), taken_), CaptureVerdict::kMoving);
  EXPECT_EQ(heldAt(at(0.05, 0.45)), CaptureVerdict::kTake);
}

TEST_F(Capture, NeverTakesAMovingBoard) {
  for (int i = 0; i < 30; ++i)  // 5 mm/s at 24 Hz
    EXPECT_EQ(rule_.judge(seenAt(at(0.05 + i * 0.005 / 24.0, 0.45)), taken_), CaptureVerdict::kMoving) << i;
}

TEST_F(Capture, TakesAViewOnceAndThenWaitsForANewOne) {
  EXPECT_EQ(heldAt(at(0.05, 0.45)), CaptureVerdict::kTake);
  taken_.push_back(seenAt(at(0.05, 0.45)));
  EXPECT_EQ(heldAt(at(0.05, 0.45)), CaptureVerdict::kNotNew);
  EXPECT_EQ(heldAt(at(0.06, 0.45)), CaptureVerdict::kNotNew);
  EXPECT_EQ(heldAt(at(0.05, 0.45, 0.4)), CaptureVerdict::kTake);
  EXPECT_EQ(heldAt(at(0.05, 0.75)), CaptureVerdict::kTake);
  EXPECT_EQ(heldAt(at(-0.02, 0.45)), CaptureVerdict::kTake);
}

TEST_F(Capture, NeedsEnoughOfTheBoardInEveryImage) {
  BoardView view = seenAt(at(0.05, 0.45));
  view.seen[1].resize(20);
  EXPECT_EQ(rule_.judge(view, taken_), CaptureVerdict::kTooFew);
  view.seen[1].clear();
  EXPECT_EQ(rule_.judge(view, taken_), CaptureVerdict::kNoBoard);
  CaptureRule mono(maker_.board, kSize, false);
  CaptureVerdict verdict = CaptureVerdict::kNoBoard;
  for (int i = 0; i < 6; ++i) verdict = mono.judge(view, taken_);
  EXPECT_EQ(verdict, CaptureVerdict::kTake);
}

TEST_F(Capture, ALostBoardStartsTheCountAgain) {
  EXPECT_EQ(heldAt(at(0.05, 0.45)), CaptureVerdict::kTake);
  EXPECT_EQ(rule_.judge({}, taken_), CaptureVerdict::kNoBoard);
  EXPECT_EQ(rule_.judge(seenAt(at(0.05, 0.45)), taken_), CaptureVerdict::kMoving);
}

TEST_F(Capture, HiddenPointsDoNotChangeTheSignature) {
  maker_.noise_px = 0.0;
  const auto whole = seenAt(at(0.05, 0.45, 0.5)).seen[0];
  Sighting part;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (i % 3 != 0 && i > 12) part.push_back(whole[i]);
  const auto a = signatureOf(whole, maker_.board, kSize), b = signatureOf(part, maker_.board, kSize);
  EXPECT_NEAR(a.x, b.x, 0.01);
  EXPECT_NEAR(a.y, b.y, 0.01);
  EXPECT_NEAR(a.size, b.size, 0.01);
  EXPECT_NEAR(a.tilt_along, b.tilt_along, 0.03);
  EXPECT_NEAR(a.tilt_across, b.tilt_across, 0.03);
}

TEST_F(Capture, TheSignatureTellsTheSideThatIsNearer) {
  maker_.noise_px = 0.0;
  const auto flat = signatureOf(seenAt(at(0.05, 0.45)).seen[0], maker_.board, kSize);
  const auto one = signatureOf(seenAt(at(0.05, 0.45, 0.5)).seen[0], maker_.board, kSize);
  const auto other = signatureOf(seenAt(at(0.05, 0.45, -0.5)).seen[0], maker_.board, kSize);
  EXPECT_NEAR(flat.tilt_along, 0.5, 0.06);
  EXPECT_NEAR(flat.tilt_across, 0.5, 0.06);
  EXPECT_GT(std::abs(one.tilt_along - other.tilt_along), 0.3);
  EXPECT_LT((one.tilt_along - 0.5) * (other.tilt_along - 0.5), 0.0);
}

TEST_F(Capture, ABoardThatLooksAlikeTurnedIsNotNewTurned) {
  maker_.board = {BoardKind::kCircles, 8, 6, 0.025};
  CaptureRule rule(maker_.board, kSize, true);
  const BoardView view = seenAt(at(0.05, 0.45, 0.4));
  BoardView turned = view;
  for (auto& sighting : turned.seen) {
    std::reverse(sighting.begin(), sighting.end());
    for (std::size_t i = 0; i < sighting.size(); ++i) sighting[i].point = static_cast<int>(i);
  }
  CaptureVerdict verdict = CaptureVerdict::kNoBoard;
  for (int i = 0; i < 6; ++i) verdict = rule.judge(i % 2 == 0 ? view : turned, {&view, 1});
  EXPECT_EQ(verdict, CaptureVerdict::kNotNew);
}

}  // namespace
}  // namespace mirrorarm::calibration
