#include "ui/model/robot_presenter.h"

#include <algorithm>
#include <cmath>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr double kNearLimit_rad = 0.15;
constexpr Seconds kSilentAfter{0.5};
constexpr Seconds kFiguresEvery{0.1};

/// Rounded before it is written, so that there is no "-0.0".
QString degrees(double angle_rad) {
  const double tenths = std::round(angle_rad * kDegrees * 10.0);
  return QStringLiteral("%1°").arg(tenths == 0.0 ? 0.0 : tenths / 10.0, 0, 'f', 1);
}

QString motionOf(const station::ControlState& control) {
  switch (control.servo.category) {
    case control::StopCategory::kNone:
      break;
    case control::StopCategory::kTwo:
      return RobotPresenter::tr("Stopped, drives on");
    case control::StopCategory::kOne:
      return RobotPresenter::tr("Stopped, drives off");
  }
  if (!control.servo.at_rest)
    return control.servo.soft_start < 1.0 ? RobotPresenter::tr("Soft start") : RobotPresenter::tr("Moving");
  const bool holds =
      control.phase == therapy::Phase::kTraining && control.servo.permit == control::Permit::kHold;
  return holds ? RobotPresenter::tr("Holding") : RobotPresenter::tr("At rest");
}

/// Where a motion was refused that tells more than how it was found.
QString wayOf(const station::ControlState& control) {
  const auto refused = control.servo.refused;
  const bool telling =
      refused != control::MotionRefusal::kNone && refused != control::MotionRefusal::kStopped;
  return telling ? words(refused) : words(control.follow);
}

void addHelp(const control::AssistState& assist, RobotFigures& figures) {
  figures.force = QStringLiteral("–");
  if (assist.force.known) {
    figures.force = RobotPresenter::tr("%1 N").arg(assist.force.force_B_n.norm(), 0, 'f', 0);
    figures.force_share = std::clamp(assist.force.limit_share, 0.0, 1.0);
    figures.force_level = assist.force.level;
  }
  figures.help = assist.gives_way ? QStringLiteral("%1 %").arg(100.0 * assist.level, 0, 'f', 0)
                                  : RobotPresenter::tr("stiff");
  figures.help_share = assist.gives_way ? assist.level : 1.0;
}

}  // namespace

RobotPresenter::RobotPresenter(const Workplace& workplace, QObject* parent)
    : QObject(parent), workplace_(workplace), kinematics_(workplace.arm) {}

JointFigures RobotPresenter::jointOf(int joint, double q_rad, double v_rad_s) const {
  const double lower = workplace_.limits.lower_rad[joint];
  const double upper = workplace_.limits.upper_rad[joint];
  JointFigures figures;
  figures.name = QString::fromStdString(workplace_.arm.joints[static_cast<std::size_t>(joint)].name);
  figures.angle = degrees(q_rad);
  figures.place = std::clamp((q_rad - lower) / (upper - lower), 0.0, 1.0);
  figures.speed_share = std::clamp(v_rad_s / workplace_.limits.max_speed_rad_s[joint], -1.0, 1.0);
  figures.near_limit = std::min(q_rad - lower, upper - q_rad) < kNearLimit_rad;
  return figures;
}

double RobotPresenter::toolSpeed(const robot::RobotState& measured) const {
  const Eigen::Matrix<double, 6, 1> twist = kinematics_.jacobian(measured.q_rad) * measured.v_rad_s;
  const Eigen::Vector3d arm_B = kinematics_.flange(measured.q_rad).linear() * workplace_.X_FE.translation();
  return (twist.head<3>() + twist.tail<3>().cross(arm_B)).norm();
}

RobotFigures RobotPresenter::figuresOf(const station::Snapshot& snapshot, TimePoint now) const {
  const auto& control = snapshot.control;
  const auto& measured = control.servo.measured;
  const int joints = workplace_.arm.jointCount();
  RobotFigures next;
  next.answers = measured.q_rad.size() == joints && now - measured.measured_at < kSilentAfter;
  next.at_rest = control.servo.at_rest;
  next.motion = next.answers ? motionOf(control) : tr("No answer");
  next.way = wayOf(control);
  addHelp(control.servo.assist, next);
  next.guard = words(control.servo.guard);
  const double lag_ms = snapshot.record.measures.lag_ms;
  next.lag = lag_ms > 0.0 ? tr("%1 ms").arg(lag_ms, 0, 'f', 0) : QStringLiteral("–");
  if (measured.q_rad.size() != joints) return next;
  const bool commanded = control.servo.commanded.v_rad_s.size() == joints;
  for (int joint = 0; joint < joints; ++joint)
    next.joints.push_back(
        jointOf(joint, measured.q_rad[joint], commanded ? control.servo.commanded.v_rad_s[joint] : 0.0));
  if (measured.v_rad_s.size() == joints) next.tool_speed_m_s = toolSpeed(measured);
  next.tool_speed_share = std::clamp(next.tool_speed_m_s / workplace_.limits.max_tool_speed_m_s, 0.0, 1.0);
  return next;
}

void RobotPresenter::show(const station::Snapshot& snapshot, TimePoint now) {
  if (now - figures_at_ < kFiguresEvery) return;
  figures_at_ = now;
  RobotFigures next = figuresOf(snapshot, now);
  if (next == figures_) return;
  figures_ = std::move(next);
  emit figuresChanged(figures_);
}

}  // namespace mirrorarm::ui
