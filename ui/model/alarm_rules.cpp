#include "ui/model/alarm_rules.h"

#include <QCoreApplication>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

struct Alarm {
  Q_DECLARE_TR_FUNCTIONS(Alarm)
};

constexpr Seconds kCameraSilentAfter{0.250};
constexpr Seconds kRobotSilentAfter{0.250};

void addStop(const station::ControlState& control, QVector<Condition>& found) {
  const auto reason = control.servo.stop;
  if (reason == control::StopReason::kNone) return;
  const auto key = QStringLiteral("stop.%1").arg(static_cast<int>(reason));
  const bool wished = reason == control::StopReason::kOperator;
  found.push_back(
      {key, wished ? Priority::kMedium : Priority::kHigh, Alarm::tr("Stopped: %1").arg(words(reason))});
}

void addCameras(const station::Snapshot& snapshot, TimePoint now, QVector<Condition>& found) {
  if (snapshot.frame == nullptr || now - snapshot.frame->frame.exposed_at <= kCameraSilentAfter) return;
  found.push_back({QStringLiteral("camera"), Priority::kHigh, Alarm::tr("The cameras deliver no images")});
}

void addRobot(const station::ControlState& control, TimePoint now, QVector<Condition>& found) {
  const auto& measured = control.servo.measured;
  if (measured.q_rad.size() == 0 || now - measured.measured_at <= kRobotSilentAfter) return;
  found.push_back({QStringLiteral("robot"), Priority::kHigh, Alarm::tr("The robot does not answer")});
}

void addForce(const control::ForceReading& force, QVector<Condition>& found) {
  if (force.level == control::ForceLevel::kWarning)
    found.push_back(
        {QStringLiteral("force.high"), Priority::kLow, Alarm::tr("The force at the sling is high")});
  if (force.level == control::ForceLevel::kSoften)
    found.push_back({QStringLiteral("force.limit"), Priority::kMedium,
                     Alarm::tr("The force at the sling is near its limit")});
}

void addTraining(const station::ControlState& control, QVector<Condition>& found) {
  if (control.phase != therapy::Phase::kTraining) return;
  if (!control.target_fresh)
    found.push_back({QStringLiteral("target"), Priority::kLow,
                     Alarm::tr("The arm target is out of view; the robot holds")});
  using control::FollowOutcome;
  if (control.follow == FollowOutcome::kOutOfReach || control.follow == FollowOutcome::kBlocked ||
      control.follow == FollowOutcome::kJointRange)
    found.push_back({QStringLiteral("follow.%1").arg(static_cast<int>(control.follow)), Priority::kLow,
                     Alarm::tr("The robot cannot follow: %1")
                         .arg(control.contact ? words(*control.contact) : words(control.follow))});
  if (control.gaze_kept)
    found.push_back({QStringLiteral("gaze"), Priority::kLow,
                     Alarm::tr("The robot stays behind, to keep the arm target in view")});
}

void addRecord(const station::RecordState& record, QVector<Condition>& found) {
  if (record.recording == station::Recording::kFailed)
    found.push_back({QStringLiteral("record"), Priority::kMedium, Alarm::tr("The record cannot be written")});
  else if (record.lost_samples > 0)
    found.push_back(
        {QStringLiteral("samples"), Priority::kLow, Alarm::tr("Some samples are missing in the record")});
}

}  // namespace

QString nameOf(Priority priority) {
  switch (priority) {
    case Priority::kLow:
      return Alarm::tr("Low");
    case Priority::kMedium:
      return Alarm::tr("Medium");
    case Priority::kHigh:
      return Alarm::tr("High");
  }
  return {};
}

QVector<Condition> conditionsOf(const station::Snapshot& snapshot, TimePoint now) {
  QVector<Condition> found;
  addStop(snapshot.control, found);
  addCameras(snapshot, now, found);
  addRobot(snapshot.control, now, found);
  addForce(snapshot.control.servo.assist.force, found);
  addTraining(snapshot.control, found);
  addRecord(snapshot.record, found);
  return found;
}

}  // namespace mirrorarm::ui
