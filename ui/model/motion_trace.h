#pragma once

#include <optional>

#include <Eigen/Core>
#include <QVector>

#include "core/station/snapshot.h"

namespace mirrorarm::ui {

/// The last seconds of both arms for the live plot: how far each is from where it was aligned, and how far
/// the sling is from its goal.
class MotionTrace {
 public:
  /// `X_FE`: sling on the flange; `window_s`: how much is kept.
  MotionTrace(const RigidTransform& X_FE, double window_s);

  /// Adds one instant; outside aligned, training and paused nothing is added, and a new alignment starts
  /// anew.
  void add(const station::Snapshot& snapshot);

  // Equally long; times in seconds, the newest 0, older ones negative. Where the healthy arm is not seen or
  // there is no goal the value is not a number, which a plot shows as a gap.
  [[nodiscard]] const QVector<double>& times() const { return shown_s_; }
  [[nodiscard]] const QVector<double>& healthy_mm() const { return healthy_mm_; }
  [[nodiscard]] const QVector<double>& impaired_mm() const { return impaired_mm_; }
  [[nodiscard]] const QVector<double>& toGoal_mm() const { return to_goal_mm_; }

 private:
  struct Start {
    Eigen::Vector3d healthy_B = Eigen::Vector3d::Zero();
    Eigen::Vector3d impaired_B = Eigen::Vector3d::Zero();
  };
  void clear();
  void forgetOld();

  RigidTransform X_FE_;
  double window_s_;
  std::optional<Start> start_;
  QVector<double> at_s_;
  QVector<double> shown_s_;
  QVector<double> healthy_mm_;
  QVector<double> impaired_mm_;
  QVector<double> to_goal_mm_;
};

}  // namespace mirrorarm::ui
