#pragma once

#include <vector>

#include <QObject>
#include <QString>

#include "core/robot/kinematics.h"
#include "core/station/snapshot.h"
#include "ui/model/workplace.h"

namespace mirrorarm::ui {

/// One joint against its limits.
struct JointFigures {
  QString name;
  QString angle;             ///< in degrees
  double place = 0.5;        ///< within its range: 0 lower limit, 1 upper limit
  double speed_share = 0.0;  ///< commanded speed to its limit, -1..1
  bool near_limit = false;
  bool operator==(const JointFigures&) const = default;
};

/// What the robot does right now. One value, compared and drawn whole.
struct RobotFigures {
  bool answers = false;  ///< a state came lately
  bool at_rest = true;
  std::vector<JointFigures> joints;
  double tool_speed_m_s = 0.0;    ///< of the sling, measured
  double tool_speed_share = 0.0;  ///< of what is allowed
  QString motion;                 ///< "At rest", "Follows", "Holding"
  QString way;                    ///< how the last goal was reached
  QString guard;                  ///< which limit the last command met
  QString lag;
  QString force;             ///< at the sling; a dash where the robot measures none
  double force_share = 0.0;  ///< of what the plan allows, 0..1
  control::ForceLevel force_level = control::ForceLevel::kCalm;
  QString help;             ///< the level, or that the robot holds its position stiffly
  double help_share = 0.0;  ///< 0..1
  bool operator==(const RobotFigures&) const = default;
};

/// Turns the servo state into figures for the robot panel.
class RobotPresenter : public QObject {
  Q_OBJECT
 public:
  explicit RobotPresenter(const Workplace& workplace, QObject* parent = nullptr);
  void show(const station::Snapshot& snapshot, TimePoint now);
  [[nodiscard]] const RobotFigures& figures() const { return figures_; }

 signals:
  void figuresChanged(const mirrorarm::ui::RobotFigures& figures);

 private:
  [[nodiscard]] JointFigures jointOf(int joint, double q_rad, double v_rad_s) const;
  [[nodiscard]] double toolSpeed(const robot::RobotState& measured) const;
  [[nodiscard]] RobotFigures figuresOf(const station::Snapshot& snapshot, TimePoint now) const;

  const Workplace& workplace_;
  robot::Kinematics kinematics_;
  RobotFigures figures_;
  TimePoint figures_at_{};
};

}  // namespace mirrorarm::ui
