#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "tests/ui/fake_calibration.h"
#include "ui/model/board_overlay.h"
#include "ui/model/calibration_presenter.h"
#include "ui/model/calibration_words.h"
#include "ui/model/view_list.h"
#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using calibration::CaptureVerdict;
using station::CalibrationAction;
using station::CalibrationAnswer;
using station::CalibrationJob;
using station::CalibrationPhase;

class Calibrating : public ::testing::Test {
 protected:
  /// Each a while after the one before, so that the words are those of the moment.
  void beat() { presenter_.show(port_.snapshot(), now_ += std::chrono::seconds(1)); }
  void ask(CalibrationAction action) {
    presenter_.ask(action);
    beat();
  }
  void begin(CalibrationJob job = CalibrationJob::kStereo) {
    beat();
    presenter_.choose(job);
    ask(CalibrationAction::kBegin);
  }
  void takeViews(int count) {
    for (int i = 0; i < count; ++i) port_.take(test::plateAt(0.4, {0.1 * i, 0, 0}));
    beat();
  }
  [[nodiscard]] const CalibrationState& state() const { return presenter_.state(); }

  camera::StereoRig rig_ = test::benchWorkplace().rig;
  test::FakeCalibration port_{rig_};
  CalibrationPresenter presenter_{port_, test::dotPlate()};
  TimePoint now_ = Clock::now();
};

TEST_F(Calibrating, LeadsFromTheChoiceToWhatIsInForce) {
  beat();
  EXPECT_EQ(state().step, CalibrationStep::kChoose);
  ASSERT_EQ(state().primary, CalibrationAction::kBegin);
  ask(CalibrationAction::kBegin);
  EXPECT_EQ(state().step, CalibrationStep::kCapture);
  EXPECT_FALSE(state().can_choose);
  takeViews(20);
  ASSERT_EQ(state().primary, CalibrationAction::kSolve);
  ask(CalibrationAction::kSolve);
  EXPECT_EQ(state().step, CalibrationStep::kResult);
  ASSERT_EQ(state().primary, CalibrationAction::kAccept);
  ask(CalibrationAction::kAccept);
  EXPECT_EQ(state().phase, CalibrationPhase::kAccepted);
  EXPECT_TRUE(state().instruction.contains(QStringLiteral("2026-11-22T113000Z-stereo")));
  EXPECT_EQ(state().job, CalibrationJob::kHandEye) << "what stands on it comes next";
  EXPECT_EQ(state().primary, CalibrationAction::kBegin);
}

TEST_F(Calibrating, TheChoiceGoesWithTheBeginning) {
  beat();
  presenter_.choose(CalibrationJob::kDrift);
  EXPECT_EQ(state().job, CalibrationJob::kDrift);
  presenter_.setBoard({calibration::BoardKind::kChessboard, 9, 6, 0.025});
  presenter_.setModel(camera::LensModel::kKannalaBrandt);
  ask(CalibrationAction::kBegin);
  EXPECT_EQ(port_.last_command.job, CalibrationJob::kDrift);
  EXPECT_EQ(port_.last_command.board.columns, 9);
  EXPECT_EQ(port_.last_command.model, camera::LensModel::kKannalaBrandt);
  presenter_.choose(CalibrationJob::kClock);
  EXPECT_EQ(state().job, CalibrationJob::kDrift) << "not while one is going on";
}

TEST_F(Calibrating, OnlyWhatThePhaseKnowsIsAllowed) {
  const auto only = [this](std::initializer_list<CalibrationAction> wanted) {
    for (std::size_t i = 0; i < kCalibrationActionCount; ++i) {
      const auto action = static_cast<CalibrationAction>(i);
      EXPECT_EQ(state().allows(action), std::ranges::find(wanted, action) != wanted.end())
          << words(action).toStdString() << " in " << nameOf(state().step).toStdString();
    }
  };
  using enum CalibrationAction;
  beat();
  only({kBegin});
  begin();
  only({kCapture, kSetAutomatic, kSetDriving, kCancel});
  takeViews(3);
  only({kCapture, kSetAutomatic, kSetDriving, kRemoveView, kSolve, kCancel});
  presenter_.removeView(0);
  beat();
  only({kCapture, kSetAutomatic, kSetDriving, kRemoveView, kUndoRemove, kSolve, kCancel});
  ask(kSolve);
  only({kAccept, kDiscard, kCancel});
  ask(kDiscard);
  EXPECT_EQ(port_.shown.views->size(), 2U) << "the views are kept";
  port_.refusal = "too few views";
  ask(kSolve);
  only({kDiscard, kCancel});
  begin(CalibrationJob::kStereo);
  ask(kCancel);
  begin(CalibrationJob::kClock);
  only({kSetDriving, kCancel});
}

TEST_F(Calibrating, EveryRefusedWishIsAnsweredInWords) {
  QStringList told;
  for (auto answer = CalibrationAnswer::kNotNow; answer <= CalibrationAnswer::kNotWritten;
       answer = static_cast<CalibrationAnswer>(static_cast<int>(answer) + 1)) {
    port_.later = answer;
    ask(CalibrationAction::kCapture);
    EXPECT_FALSE(state().message.isEmpty());
    EXPECT_FALSE(told.contains(state().message)) << state().message.toStdString();
    told << state().message;
  }
  port_.later = CalibrationAnswer::kAccepted;
  begin();
  EXPECT_TRUE(state().message.isEmpty()) << "an accepted wish clears the refusal";
  port_.at_once = CalibrationAnswer::kQueueFull;
  presenter_.setAutomatic(false);
  EXPECT_EQ(state().message, words(CalibrationAnswer::kQueueFull)) << "without a beat";
}

TEST_F(Calibrating, AStopForbidsDrivingAndOffersItsReset) {
  begin();
  presenter_.setDriving(true);
  beat();
  EXPECT_TRUE(state().driving);
  presenter_.stop();
  EXPECT_EQ(port_.stops, 1);
  beat();
  EXPECT_TRUE(state().stopped);
  EXPECT_FALSE(state().allows(CalibrationAction::kSetDriving));
  EXPECT_TRUE(state().allows(CalibrationAction::kCapture)) << "taking a view moves nothing";
  EXPECT_TRUE(state().instruction.contains(words(control::StopReason::kOperator)));
  presenter_.resetStop();
  beat();
  EXPECT_FALSE(state().stopped);
  EXPECT_FALSE(state().driving) << "a reset starts nothing";
}

TEST_F(Calibrating, SaysWhatKeepsAViewFromBeingTaken) {
  begin();
  EXPECT_TRUE(state().title.contains(QStringLiteral("images"))) << state().title.toStdString();
  port_.seeNothing();
  beat();
  EXPECT_TRUE(state().title.contains(QStringLiteral("Show the board")));
  QStringList titles{state().title};
  for (const auto verdict : {CaptureVerdict::kTooFew, CaptureVerdict::kMoving, CaptureVerdict::kNotNew}) {
    port_.see(test::plateAt(0.4), verdict);
    beat();
    EXPECT_FALSE(titles.contains(state().title));
    titles << state().title;
  }
  port_.shown.automatic = false;
  port_.see(test::plateAt(0.4), CaptureVerdict::kTake);
  beat();
  EXPECT_EQ(state().primary, CalibrationAction::kCapture);
}

TEST_F(Calibrating, ALargerBoardIsNamedWithTheRemedy) {
  begin();
  auto frame = std::make_shared<station::BoardFrame>();
  frame->larger_board = true;
  port_.shown.frame = frame;
  beat();
  EXPECT_TRUE(state().instruction.contains(QStringLiteral("9 × 7"))) << state().instruction.toStdString();
  EXPECT_EQ(state().primary, CalibrationAction::kCancel);
}

TEST_F(Calibrating, ARefusedSolutionGivesItsReasonAndTheWayBack) {
  begin();
  takeViews(3);
  port_.refusal = "the views show the board from one side only: tilt it";
  ask(CalibrationAction::kSolve);
  EXPECT_EQ(state().instruction.toStdString(), port_.refusal);
  EXPECT_EQ(state().primary, CalibrationAction::kDiscard);
}

TEST_F(Calibrating, ABadResultIsNotTheOneToAccept) {
  auto outcome = test::stereoOutcome(rig_);
  outcome.result.hold_out->epipolar_px = 0.9;
  port_.outcome = std::make_shared<station::CalibrationOutcome>(outcome);
  begin();
  takeViews(20);
  ask(CalibrationAction::kSolve);
  EXPECT_EQ(presenter_.result().light, Light::kBad);
  EXPECT_EQ(state().primary, CalibrationAction::kDiscard);
}

TEST_F(Calibrating, WordsStandLongEnoughToBeRead) {
  begin();
  port_.see(test::plateAt(0.4), CaptureVerdict::kMoving);
  beat();
  const QString title = state().title;
  port_.see(test::plateAt(0.4), CaptureVerdict::kNotNew);
  presenter_.show(port_.snapshot(), now_ + std::chrono::milliseconds(100));
  EXPECT_EQ(state().title, title);
  EXPECT_EQ(state().lights[2].light, Light::kGood) << "the lights follow at once";
  presenter_.show(port_.snapshot(), now_ + std::chrono::milliseconds(700));
  EXPECT_NE(state().title, title);
}

TEST_F(Calibrating, NothingIsPublishedWhileNothingChanges) {
  begin();
  takeViews(4);
  int published = 0;
  QObject::connect(&presenter_, &CalibrationPresenter::stateChanged, [&published] { ++published; });
  for (int i = 0; i < 10; ++i) beat();
  EXPECT_EQ(published, 0);
}

TEST_F(Calibrating, TheLightsTellWhatIsWanting) {
  begin();
  port_.seeNothing();
  beat();
  ASSERT_EQ(state().lights.size(), 8);
  EXPECT_EQ(state().lights[0].light, Light::kBad) << "the board is not seen";
  EXPECT_EQ(state().lights[2].light, Light::kOff) << "so nothing can be said of its rest";
  port_.see(test::plateAt(0.4), CaptureVerdict::kNotNew);
  beat();
  EXPECT_EQ(state().lights[0].light, Light::kGood);
  EXPECT_EQ(state().lights[0].value, QStringLiteral("63 of 63"));
  EXPECT_EQ(state().lights[2].light, Light::kGood) << "still";
  EXPECT_EQ(state().lights[3].light, Light::kWaiting) << "not new";
  EXPECT_EQ(state().lights[4].light, Light::kWaiting);
  takeViews(20);
  EXPECT_EQ(state().lights[4].light, Light::kGood) << "enough views";
  EXPECT_EQ(state().lights[6].light, Light::kGood) << "three of four tilts";
}

TEST_F(Calibrating, TheClockAsksForMovementNotForViews) {
  begin(CalibrationJob::kClock);
  port_.see(test::plateAt(0.4), CaptureVerdict::kMoving);
  beat();
  EXPECT_EQ(state().primary, CalibrationAction::kSetDriving);
  port_.shown.progress = 1.0;
  beat();
  EXPECT_EQ(state().primary, CalibrationAction::kSolve);
  EXPECT_EQ(state().lights.back().light, Light::kGood);
}

TEST_F(Calibrating, TheListShowsEachViewAndWhatSolvingSaidOfIt) {
  begin();
  takeViews(2);
  auto views = *port_.shown.views;
  views[1].residual_px = 0.0234;
  views[1].is_outlier = true;
  port_.shown.views = std::make_shared<const std::vector<station::TakenView>>(views);
  ViewList list;
  list.show(port_.snapshot());
  ASSERT_EQ(list.rowCount(), 2);
  const auto cell = [&list](int row, int column) { return list.data(list.index(row, column)).toString(); };
  EXPECT_EQ(cell(0, ViewList::kName), QStringLiteral("view-01"));
  EXPECT_EQ(cell(0, ViewList::kPoints), QStringLiteral("63 | 63"));
  EXPECT_EQ(cell(0, ViewList::kRemark), QString());
  EXPECT_EQ(cell(1, ViewList::kResidual), QStringLiteral("0.023 px"));
  EXPECT_FALSE(cell(1, ViewList::kRemark).isEmpty());
  presenter_.removeView(0);
  EXPECT_EQ(port_.last_command.view, 0U);
  list.show(port_.snapshot());
  EXPECT_EQ(list.rowCount(), 1);
}

TEST_F(Calibrating, TheImagesShowThePointsTheirNumbersAndTheProposal) {
  begin();
  const auto X_CM = test::plateAt(0.4);
  port_.see(X_CM, CaptureVerdict::kNotNew);
  port_.shown.proposal = calibration::ViewWish{X_CM, 1.0};
  const auto [left, right] = boardOverlaysOf(port_.snapshot(), rig_);
  ASSERT_EQ(left.points.size(), 63U);
  EXPECT_EQ(left.points.front().label, QStringLiteral("1"));
  EXPECT_EQ(left.points.back().label, QStringLiteral("63"));
  EXPECT_TRUE(left.points[1].label.isEmpty());
  ASSERT_EQ(left.outline_px.size(), 28U) << "once around 9 x 7";
  ASSERT_EQ(right.wished_px.size(), 28U);
  for (std::size_t i = 0; i < 28; ++i) {
    EXPECT_NEAR(right.wished_px[i].x(), right.outline_px[i].x(), 1e-6) << "the view is the one proposed";
    EXPECT_NEAR(right.wished_px[i].y(), right.outline_px[i].y(), 1e-6);
  }
  EXPECT_TRUE(boardOverlaysOf(port_.snapshot(), std::nullopt)[0].wished_px.empty());
}

}  // namespace
}  // namespace mirrorarm::ui
