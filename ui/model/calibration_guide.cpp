#include "ui/model/calibration_guide.h"

#include <QCoreApplication>

#include "ui/model/calibration_words.h"
#include "ui/model/view_guidance.h"
#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using calibration::CaptureVerdict;
using station::CalibrationAction;
using station::CalibrationJob;
using station::CalibrationPhase;
using station::CalibrationSnapshot;

struct Guide {
  Q_DECLARE_TR_FUNCTIONS(CalibrationGuide)
};

/// Before hand-eye, clock and drift the board lies still and the robot moves the cameras.
Moved movedIn(CalibrationJob job) { return job == CalibrationJob::kStereo ? Moved::kBoard : Moved::kCameras; }

QString preparation(CalibrationJob job) {
  switch (job) {
    case CalibrationJob::kStereo:
      return Guide::tr("Have the board ready: on the table for the robot to look at, or in your hand.");
    case CalibrationJob::kHandEye:
      return Guide::tr("Lay the board before the cameras. It must not move until the end.");
    case CalibrationJob::kClock:
      return Guide::tr("Lay the board before the cameras. The robot turns them to and fro for some seconds.");
    case CalibrationJob::kDrift:
      return Guide::tr(
          "Lay the board before the cameras. One view is enough, a grid of the robot tells more.");
  }
  return {};
}

CalibrationGuide choosing(CalibrationJob chosen) {
  return {words(chosen), purpose(chosen) + QLatin1Char(' ') + preparation(chosen), CalibrationAction::kBegin};
}

CalibrationGuide stopped(const CalibrationSnapshot& snapshot) {
  const auto reason = snapshot.servo.stop;
  const QString next = reason == control::StopReason::kOperator
                           ? Guide::tr(
                                 "Make sure that nothing is in the robot's way, then reset the stop; "
                                 "nothing moves by that.")
                           : advice(reason);
  return {Guide::tr("Stopped"), words(reason) + QStringLiteral(". ") + next, std::nullopt};
}

CalibrationGuide unseen(const CalibrationSnapshot& snapshot) {
  if (snapshot.frame->larger_board)
    return {
        Guide::tr("Another board"),
        Guide::tr("The pattern goes on beyond %1 × %2 points. Discard all and choose the board's true size.")
            .arg(snapshot.board.columns)
            .arg(snapshot.board.rows),
        CalibrationAction::kCancel};
  return {Guide::tr("Show the board"), Guide::tr("Both cameras must see it, whole and evenly lit."),
          std::nullopt};
}

QString toNextView(const CalibrationSnapshot& snapshot) {
  const auto general = [&] {
    return movedIn(snapshot.job) == Moved::kBoard
               ? Guide::tr("This view was taken. Tilt the board, or bring it where no points have been yet.")
               : Guide::tr("This view was taken. Turn the cameras about another axis.");
  };
  if (!snapshot.proposal || !snapshot.frame->X_CM) return general();
  const QStringList steps =
      guidanceTo(snapshot.proposal->X_CM, *snapshot.frame->X_CM, snapshot.board, movedIn(snapshot.job));
  return steps.isEmpty() ? general() : steps.join(QLatin1Char('\n'));
}

CalibrationGuide taking(const CalibrationSnapshot& snapshot) {
  if (snapshot.automatic) return {Guide::tr("Hold still"), Guide::tr("The view is taken."), std::nullopt};
  return {Guide::tr("Ready to capture"), Guide::tr("The board is still and the view is new."),
          CalibrationAction::kCapture};
}

CalibrationGuide byVerdict(const CalibrationSnapshot& snapshot) {
  switch (snapshot.frame->verdict) {
    case CaptureVerdict::kNoBoard:
      return unseen(snapshot);
    case CaptureVerdict::kTooFew:
      return {
          Guide::tr("Show more of the board"),
          Guide::tr(
              "Most of its points must be seen by both cameras: uncover it, or bring it into the middle."),
          std::nullopt};
    case CaptureVerdict::kMoving:
      return {Guide::tr("Hold still"), Guide::tr("The view is taken as soon as nothing moves."),
              std::nullopt};
    case CaptureVerdict::kNotNew:
      return {Guide::tr("Show it in another way"), toNextView(snapshot), std::nullopt};
    case CaptureVerdict::kTake:
      return taking(snapshot);
  }
  return {};
}

bool isEnough(const CalibrationSnapshot& snapshot) {
  if (snapshot.job == CalibrationJob::kClock) return snapshot.progress >= 1.0;
  return snapshot.views && !snapshot.views->empty() && snapshot.views->size() >= snapshot.views_wanted;
}

CalibrationGuide driving(const CalibrationSnapshot& snapshot) {
  return {snapshot.job == CalibrationJob::kClock ? Guide::tr("The robot turns the cameras")
                                                 : Guide::tr("The robot drives to the next view"),
          Guide::tr("Keep a hand near STOP. What is seen is taken by itself."), std::nullopt};
}

CalibrationGuide clockGuide() {
  return {Guide::tr("Let the robot drive"),
          Guide::tr("Both clocks are compared by one movement that the robot makes and the cameras see."),
          CalibrationAction::kSetDriving};
}

CalibrationGuide capturing(const CalibrationSnapshot& snapshot) {
  if (isEnough(snapshot))
    return {Guide::tr("Ready to solve"), Guide::tr("Solve now, or go on: more views make the result surer."),
            CalibrationAction::kSolve};
  if (snapshot.driving) return driving(snapshot);
  if (!snapshot.frame)
    return {Guide::tr("Waiting for images"), Guide::tr("The cameras have not delivered an image yet."),
            std::nullopt};
  const bool seen = snapshot.frame->verdict > CaptureVerdict::kTooFew;
  return snapshot.job == CalibrationJob::kClock && seen ? clockGuide() : byVerdict(snapshot);
}

CalibrationGuide solved(Light result) {
  const bool bad = result == Light::kBad;
  return {Guide::tr("Look at the result"),
          Guide::tr("Accepting writes the record and puts it in force. Until then nothing has changed."),
          bad ? CalibrationAction::kDiscard : CalibrationAction::kAccept};
}

}  // namespace

CalibrationGuide guideOf(const CalibrationSnapshot& snapshot, CalibrationJob chosen, Light result) {
  if (snapshot.servo.stop != control::StopReason::kNone) return stopped(snapshot);
  switch (snapshot.phase) {
    case CalibrationPhase::kIdle:
      return choosing(chosen);
    case CalibrationPhase::kCapturing:
      return capturing(snapshot);
    case CalibrationPhase::kSolving:
      return {Guide::tr("Solving"),
              Guide::tr("All views are brought into agreement. This takes some seconds."), std::nullopt};
    case CalibrationPhase::kSolved:
      return solved(result);
    case CalibrationPhase::kRefused:
      return {Guide::tr("No result"), QString::fromStdString(snapshot.refusal), CalibrationAction::kDiscard};
    case CalibrationPhase::kAccepted:
      return {Guide::tr("In force"),
              Guide::tr("Record %1 is written. Next: %2.")
                  .arg(QString::fromStdString(snapshot.record), words(chosen)),
              CalibrationAction::kBegin};
  }
  return {};
}

}  // namespace mirrorarm::ui
