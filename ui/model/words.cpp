#include "ui/model/words.h"

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {
struct Words {
  Q_DECLARE_TR_FUNCTIONS(Words)
};
}  // namespace

QString words(control::StopReason reason) {
  switch (reason) {
    case control::StopReason::kNone:
      return Words::tr("Not stopped");
    case control::StopReason::kOperator:
      return Words::tr("The operator pressed STOP");
    case control::StopReason::kCameraSilent:
      return Words::tr("The cameras deliver no images");
    case control::StopReason::kTargetLost:
      return Words::tr("The arm target was lost");
    case control::StopReason::kRobotSilent:
      return Words::tr("The robot does not answer");
    case control::StopReason::kRobotFault:
      return Words::tr("The robot reports a fault");
    case control::StopReason::kServoLate:
      return Words::tr("The motion loop missed its beat");
    case control::StopReason::kFollowingError:
      return Words::tr("The robot is not where it was told to be");
    case control::StopReason::kInternal:
      return Words::tr("An internal error ended the motion");
    case control::StopReason::kPoorLine:
      return Words::tr("The line to the robot is too bad");
    case control::StopReason::kPlannerSilent:
      return Words::tr("The planning of the motion stood still");
    case control::StopReason::kEnablingReleased:
      return Words::tr("The enabling key was let go");
    case control::StopReason::kEnablingPressedThrough:
      return Words::tr("The enabling key was pressed through");
    case control::StopReason::kForce:
      return Words::tr("The force at the sling became too large");
  }
  return {};
}

QString advice(control::StopReason reason) {
  switch (reason) {
    case control::StopReason::kNone:
      return {};
    case control::StopReason::kOperator:
      return Words::tr("Make sure that the patient is well. Then reset the stop; nothing moves by that.");
    case control::StopReason::kCameraSilent:
      return Words::tr("Check the camera cables and power, then reset the stop.");
    case control::StopReason::kTargetLost:
      return Words::tr("Bring the markers of the healthy arm back into view, then reset the stop.");
    case control::StopReason::kRobotSilent:
    case control::StopReason::kRobotFault:
      return Words::tr("Look at the robot controller and clear its fault, then reset the stop.");
    case control::StopReason::kFollowingError:
      return Words::tr("Make sure that nothing holds the robot, then reset the stop.");
    case control::StopReason::kPoorLine:
      return Words::tr("Check the network cable to the robot controller, then reset the stop.");
    case control::StopReason::kServoLate:
    case control::StopReason::kPlannerSilent:
    case control::StopReason::kInternal:
      return Words::tr("Close other programs. If it comes again, call the engineer.");
    case control::StopReason::kEnablingReleased:
      return Words::tr("Reset the stop, hold the enabling key and start again.");
    case control::StopReason::kEnablingPressedThrough:
      return Words::tr(
          "Make sure that the patient is well. Let the enabling key go fully, then reset the stop.");
    case control::StopReason::kForce:
      return Words::tr(
          "Free the patient's arm from the strain and ask whether anything hurts, then reset the stop.");
  }
  return {};
}

QString whyNoReset(const control::ServoState& servo) {
  switch (servo.reset) {
    case control::ResetRefusal::kNone:
    case control::ResetRefusal::kNotStopped:
      return {};
    case control::ResetRefusal::kMoving:
      return Words::tr("The stop can be reset once the robot is at rest");
    case control::ResetRefusal::kCausePersists:
      return Words::tr("The stop cannot be reset yet: %1").arg(words(servo.lasting));
  }
  return {};
}

QString words(control::EnablingPosition position) {
  switch (position) {
    case control::EnablingPosition::kReleased:
      return Words::tr("Released");
    case control::EnablingPosition::kEnabled:
      return Words::tr("Enabled");
    case control::EnablingPosition::kPressedThrough:
      return Words::tr("Pressed through");
  }
  return {};
}

QString words(const control::Help& help) {
  if (help.adapts) return Words::tr("The help adapts to the patient");
  return Words::tr("Help fixed at %1 %").arg(100.0 * help.level, 0, 'f', 0);
}

QString words(control::MotionRefusal refusal) {
  switch (refusal) {
    case control::MotionRefusal::kNone:
      return Words::tr("Accepted");
    case control::MotionRefusal::kStopped:
      return Words::tr("Stopped");
    case control::MotionRefusal::kNotEnabled:
      return Words::tr("Not enabled");
    case control::MotionRefusal::kStartElsewhere:
      return Words::tr("Begins elsewhere");
    case control::MotionRefusal::kRobotNotReady:
      return Words::tr("Robot not ready");
  }
  return {};
}

QString words(const robot::Contact& contact) {
  const QString part = contact.part == robot::ArmPart::kSling       ? Words::tr("The sling")
                       : contact.part == robot::ArmPart::kCameraBar ? Words::tr("The camera bar")
                                                                    : Words::tr("The arm");
  if (!contact.obstacle) return Words::tr("%1 would touch the arm").arg(part);
  switch (*contact.obstacle) {
    case robot::ObstacleKind::kHead:
      return Words::tr("%1 would come too near the head").arg(part);
    case robot::ObstacleKind::kTable:
      return Words::tr("%1 would touch the table").arg(part);
    case robot::ObstacleKind::kBox:
      return Words::tr("%1 would touch: %2").arg(part, QString::fromStdString(contact.name));
  }
  return part;
}

QString words(control::FollowOutcome outcome) {
  switch (outcome) {
    case control::FollowOutcome::kDirect:
      return Words::tr("Direct way");
    case control::FollowOutcome::kPlanned:
      return Words::tr("Planned detour");
    case control::FollowOutcome::kPlanning:
      return Words::tr("Planning a detour");
    case control::FollowOutcome::kHeld:
      return Words::tr("Holding");
    case control::FollowOutcome::kOutOfReach:
      return Words::tr("Goal out of reach");
    case control::FollowOutcome::kBlocked:
      return Words::tr("Way is blocked");
    case control::FollowOutcome::kJointRange:
      return Words::tr("Joint step too large");
  }
  return {};
}

QString words(robot::GuardAction action) {
  switch (action) {
    case robot::GuardAction::kPassed:
      return Words::tr("Within limits");
    case robot::GuardAction::kNotFinite:
      return Words::tr("Braked: invalid command");
    case robot::GuardAction::kFollowingError:
      return Words::tr("Braked: robot is not where it should be");
    case robot::GuardAction::kPosition:
      return Words::tr("Joint range");
    case robot::GuardAction::kCollision:
      return Words::tr("Close to an obstacle");
    case robot::GuardAction::kJerk:
      return Words::tr("Joint jerk");
    case robot::GuardAction::kAcceleration:
      return Words::tr("Joint acceleration");
    case robot::GuardAction::kSpeed:
      return Words::tr("Joint speed");
    case robot::GuardAction::kZoneSpeed:
      return Words::tr("Slow near the head");
    case robot::GuardAction::kToolSpeed:
      return Words::tr("Tool speed");
    case robot::GuardAction::kToolAcceleration:
      return Words::tr("Tool acceleration");
  }
  return {};
}

QString words(station::Answer answer) {
  switch (answer) {
    case station::Answer::kAccepted:
      return Words::tr("Accepted");
    case station::Answer::kNotNow:
      return Words::tr("Not possible in this step");
    case station::Answer::kStopLatched:
      return Words::tr("Reset the stop first");
    case station::Answer::kNotEnabled:
      return Words::tr("Hold the enabling key, then start");
    case station::Answer::kTargetUnseen:
      return Words::tr("The arm target is not in view");
    case station::Answer::kNotCalibrated:
      return Words::tr("The calibration does not hold: calibrate, or check it, before a session");
    case station::Answer::kTooFewMarkers:
      return Words::tr("At least three markers that are not on one line must be seen");
    case station::Answer::kHoldsStiffly:
      return Words::tr("The robot holds its position stiffly");
    case station::Answer::kOutOfRange:
      return Words::tr("The help lies between 0 and 100 %");
    case station::Answer::kQueueFull:
      return Words::tr("The station is busy. Ask again");
  }
  return {};
}

QString words(station::Recording recording) {
  switch (recording) {
    case station::Recording::kIdle:
      return Words::tr("Not recording");
    case station::Recording::kWriting:
      return Words::tr("Recording");
    case station::Recording::kComplete:
      return Words::tr("Recorded");
    case station::Recording::kFailed:
      return Words::tr("Recording failed");
  }
  return {};
}

QString words(therapy::Mapping mapping) {
  switch (mapping) {
    case therapy::Mapping::kFollow:
      return Words::tr("Parallel");
    case therapy::Mapping::kMirror:
      return Words::tr("Mirrored");
  }
  return {};
}

QString words(therapy::Phase phase) {
  switch (phase) {
    case therapy::Phase::kPrepare:
      return Words::tr("Preparing");
    case therapy::Phase::kTeaching:
      return Words::tr("Teaching");
    case therapy::Phase::kTaught:
      return Words::tr("Target taught");
    case therapy::Phase::kAligned:
      return Words::tr("Aligned");
    case therapy::Phase::kTraining:
      return Words::tr("Training");
    case therapy::Phase::kPaused:
      return Words::tr("Paused");
    case therapy::Phase::kFinished:
      return Words::tr("Finished");
  }
  return {};
}

QString words(therapy::Action action) {
  switch (action) {
    case therapy::Action::kTeach:
      return Words::tr("Teach markers");
    case therapy::Action::kFinishTeaching:
      return Words::tr("Keep these markers");
    case therapy::Action::kAlign:
      return Words::tr("Align");
    case therapy::Action::kStart:
      return Words::tr("Start training");
    case therapy::Action::kPause:
      return Words::tr("Pause");
    case therapy::Action::kFinish:
      return Words::tr("Finish session");
    case therapy::Action::kNewSession:
      return Words::tr("New session");
  }
  return {};
}

QString words(tracking::TrackStatus status) {
  switch (status) {
    case tracking::TrackStatus::kTracked:
      return Words::tr("Tracked");
    case tracking::TrackStatus::kPredicted:
      return Words::tr("Predicted");
    case tracking::TrackStatus::kLost:
      return Words::tr("Lost");
  }
  return {};
}

QString words(tracking::LostReason reason) {
  switch (reason) {
    case tracking::LostReason::kNone:
      return {};
    case tracking::LostReason::kNoPoints:
      return Words::tr("no markers in view");
    case tracking::LostReason::kTooFewMarkers:
      return Words::tr("too few markers in view");
    case tracking::LostReason::kBadFit:
      return Words::tr("markers do not fit the model");
    case tracking::LostReason::kNotConverged:
      return Words::tr("pose not found");
    case tracking::LostReason::kAmbiguous:
      return Words::tr("markers fit in several ways");
    case tracking::LostReason::kOutOfVolume:
      return Words::tr("outside the cameras' view");
    case tracking::LostReason::kStale:
      return Words::tr("not seen for too long");
  }
  return {};
}

QString words(tracking::SkinEvent event) {
  switch (event) {
    case tracking::SkinEvent::kNone:
      return {};
    case tracking::SkinEvent::kSlipped:
      return Words::tr("The sleeve has slipped; the markers were taught anew");
    case tracking::SkinEvent::kMarkerLost:
      return Words::tr("A marker has fallen off");
    case tracking::SkinEvent::kMarkerFound:
      return Words::tr("A marker is back");
    case tracking::SkinEvent::kMarkerAdded:
      return Words::tr("A new marker moves with the arm; it was added");
  }
  return {};
}

QString words(vision::Rejection reason) {
  switch (reason) {
    case vision::Rejection::kTooSmall:
      return Words::tr("too small");
    case vision::Rejection::kTooLarge:
      return Words::tr("too large");
    case vision::Rejection::kTooElongated:
      return Words::tr("too long");
    case vision::Rejection::kNotAnEllipse:
      return Words::tr("not round");
    case vision::Rejection::kAtBorder:
      return Words::tr("at the border");
    case vision::Rejection::kSaturated:
      return Words::tr("too bright");
    case vision::Rejection::kCut:
      return Words::tr("mostly covered");
  }
  return {};
}

QString words(vision::ExposureWarning warning) {
  switch (warning) {
    case vision::ExposureWarning::kSaturated:
      return Words::tr("too bright");
    case vision::ExposureWarning::kBrightBackground:
      return Words::tr("bright background");
    case vision::ExposureWarning::kTooDark:
      return Words::tr("too dark");
  }
  return {};
}

QString advice(vision::ExposureWarning warning) {
  switch (warning) {
    case vision::ExposureWarning::kSaturated:
      return Words::tr("shorten the exposure");
    case vision::ExposureWarning::kBrightBackground:
      return Words::tr("shut out daylight");
    case vision::ExposureWarning::kTooDark:
      return Words::tr("uncover it or expose longer");
  }
  return {};
}

}  // namespace mirrorarm::ui
