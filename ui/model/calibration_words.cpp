#include "ui/model/calibration_words.h"

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {
struct CalibrationWords {
  Q_DECLARE_TR_FUNCTIONS(CalibrationWords)
};
}  // namespace

QString words(station::CalibrationJob job) {
  switch (job) {
    case station::CalibrationJob::kStereo:
      return CalibrationWords::tr("Stereo cameras");
    case station::CalibrationJob::kHandEye:
      return CalibrationWords::tr("Hand-eye");
    case station::CalibrationJob::kClock:
      return CalibrationWords::tr("Clock offset");
    case station::CalibrationJob::kDrift:
      return CalibrationWords::tr("Drift check");
  }
  return {};
}

QString purpose(station::CalibrationJob job) {
  switch (job) {
    case station::CalibrationJob::kStereo:
      return CalibrationWords::tr(
          "Finds the numbers of both lenses and how the cameras stand to each other.");
    case station::CalibrationJob::kHandEye:
      return CalibrationWords::tr("Finds where the cameras sit on the robot's flange.");
    case station::CalibrationJob::kClock:
      return CalibrationWords::tr("Finds how far the cameras' clock is off the robot's.");
    case station::CalibrationJob::kDrift:
      return CalibrationWords::tr("Tells whether what is in force still holds.");
  }
  return {};
}

QString words(station::CalibrationAction action) {
  using station::CalibrationAction;
  switch (action) {
    case CalibrationAction::kBegin:
      return CalibrationWords::tr("Begin");
    case CalibrationAction::kCapture:
      return CalibrationWords::tr("Capture now");
    case CalibrationAction::kSetAutomatic:
      return CalibrationWords::tr("Capture by itself");
    case CalibrationAction::kSetDriving:
      return CalibrationWords::tr("Robot drives");
    case CalibrationAction::kRemoveView:
      return CalibrationWords::tr("Remove view");
    case CalibrationAction::kUndoRemove:
      return CalibrationWords::tr("Undo");
    case CalibrationAction::kSolve:
      return CalibrationWords::tr("Solve");
    case CalibrationAction::kAccept:
      return CalibrationWords::tr("Accept");
    case CalibrationAction::kDiscard:
      return CalibrationWords::tr("Back to the views");
    case CalibrationAction::kCancel:
      return CalibrationWords::tr("Discard all");
  }
  return {};
}

QString words(station::CalibrationAnswer answer) {
  using station::CalibrationAnswer;
  switch (answer) {
    case CalibrationAnswer::kAccepted:
      return CalibrationWords::tr("Accepted");
    case CalibrationAnswer::kNotNow:
      return CalibrationWords::tr("Not possible in this step");
    case CalibrationAnswer::kNoBoard:
      return CalibrationWords::tr("Both cameras must see the board. Show it to them and capture again");
    case CalibrationAnswer::kMoving:
      return CalibrationWords::tr("The board moves. Hold it still and capture again");
    case CalibrationAnswer::kNoRobot:
      return CalibrationWords::tr("The robot does not answer or is not at rest. Look at its controller");
    case CalibrationAnswer::kNotEnabled:
      return CalibrationWords::tr("Hold the enabling key, then let the robot drive");
    case CalibrationAnswer::kStopLatched:
      return CalibrationWords::tr("Reset the stop first");
    case CalibrationAnswer::kNoCalibration:
      return CalibrationWords::tr(
          "A calibration that this one stands on is missing. Do it first: stereo "
          "cameras, then hand-eye, then the others");
    case CalibrationAnswer::kNotWritten:
      return CalibrationWords::tr(
          "The record could not be written, and what was in force still is. Make "
          "room in the folder of the calibrations and accept again");
    case CalibrationAnswer::kQueueFull:
      return CalibrationWords::tr("The station is busy. Ask again");
  }
  return {};
}

QString words(calibration::BoardKind kind) {
  switch (kind) {
    case calibration::BoardKind::kChessboard:
      return CalibrationWords::tr("Chessboard");
    case calibration::BoardKind::kCircles:
      return CalibrationWords::tr("Circles");
    case calibration::BoardKind::kAsymmetricCircles:
      return CalibrationWords::tr("Asymmetric circles");
    case calibration::BoardKind::kDotPlate:
      return CalibrationWords::tr("Dot plate");
  }
  return {};
}

QString words(calibration::DriftVerdict verdict) {
  switch (verdict) {
    case calibration::DriftVerdict::kHolds:
      return CalibrationWords::tr("The calibrations hold");
    case calibration::DriftVerdict::kDoubtful:
      return CalibrationWords::tr("Doubtful: calibrate soon");
    case calibration::DriftVerdict::kFailed:
      return CalibrationWords::tr("Failed: calibrate before a session");
  }
  return {};
}

QString words(camera::LensModel model) {
  switch (model) {
    case camera::LensModel::kBrownConrady:
      return QStringLiteral("Brown-Conrady");
    case camera::LensModel::kKannalaBrandt:
      return QStringLiteral("Kannala-Brandt");
  }
  return {};
}

}  // namespace mirrorarm::ui
