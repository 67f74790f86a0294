#pragma once

#include "core/robot/trajectory.h"

namespace mirrorarm::robot {

/// Finds the duration of a motion through way points. All pieces are stretched by one factor, tried in rising
/// order until the limits hold, then refined.
class Trajectory::Timing {
 public:
  Timing(const MotionState& from, std::span<const Joints> waypoints, const MotionLimits& limits);

  /// The fastest motion within the limits that lasts `at_least`.
  void fastest(Seconds at_least);
  /// Appends what was found.
  void appendTo(Trajectory& trajectory) const;

 private:
  void allowOwnStart();
  [[nodiscard]] double shortest(std::size_t piece) const;
  [[nodiscard]] double firstWithin(double allowed, double stretch, double& best);
  [[nodiscard]] double refined(double too_short, double long_enough, double allowed);
  void build(double stretch);
  [[nodiscard]] Joints passingSpeed(std::size_t k, double stretch) const;
  [[nodiscard]] double excessAt(double stretch);
  [[nodiscard]] double excessOf(std::size_t k, Eigen::Index j) const;

  struct Stretch {
    double duration_s = 0.0;
    std::array<Polynomial, kMaxJoints> joints{};
  };
  const MotionState& from_;
  std::span<const Joints> waypoints_;
  const MotionLimits& limits_;
  Joints speed_, acceleration_, jerk_, lower_, upper_;
  std::array<double, kMaxPieces> shortest_s_{};
  std::array<Stretch, kMaxPieces> pieces_{};
};

}  // namespace mirrorarm::robot
