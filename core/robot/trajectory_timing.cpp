#include "core/robot/trajectory_timing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace mirrorarm::robot {
namespace {

constexpr double kShortestPiece_s = 0.02;
constexpr double kStretch = 1.05;  // between two durations tried
constexpr int kMaxStretches = 120;
constexpr double kTolerance = 1e-9;
constexpr double kOutsideScale_rad = 0.01;  // as bad as twice the speed: this far outside a joint range
// Largest speed, acceleration and jerk of a quintic from rest to rest over distance and duration 1.
constexpr double kPeakSpeed = 1.875, kPeakAcceleration = 5.773502691896258, kPeakJerk = 60.0;

double largestRatio(const Joints& numbers, const Joints& limits) {
  return (numbers.array().abs() / limits.array()).maxCoeff();
}

double magnitude(const Range& range) { return std::max(std::abs(range.least), std::abs(range.most)); }

}  // namespace

Trajectory::Timing::Timing(const MotionState& from, std::span<const Joints> waypoints,
                           const MotionLimits& limits)
    : from_(from), waypoints_(waypoints), limits_(limits) {
  allowOwnStart();
  for (std::size_t piece = 0; piece < waypoints.size(); ++piece) shortest_s_[piece] = shortest(piece);
}

void Trajectory::Timing::fastest(Seconds at_least) {
  double total = 0.0;
  for (std::size_t piece = 0; piece < waypoints_.size(); ++piece) total += shortest_s_[piece];
  const double first = std::max(1.0, at_least.count() / total);
  double allowed = 1.0 + kTolerance;
  double best = std::numeric_limits<double>::infinity();
  double stretch = firstWithin(allowed, first, best);
  if (stretch == 0.0) stretch = firstWithin(allowed = 1.01 * best, first, best);
  build(stretch > first ? refined(stretch / kStretch, stretch, allowed) : stretch);
}

void Trajectory::Timing::appendTo(Trajectory& trajectory) const {
  for (Eigen::Index j = 0; j < from_.q_rad.size(); ++j)
    for (std::size_t k = 0; k < waypoints_.size(); ++k)
      trajectory.joint(j).append(pieces_[k].duration_s, pieces_[k].joints[static_cast<std::size_t>(j)]);
}

// What the moving start already exceeds cannot be avoided and is no excess.
void Trajectory::Timing::allowOwnStart() {
  speed_ = limits_.max_speed_rad_s.cwiseMax(from_.v_rad_s.cwiseAbs());
  acceleration_ = limits_.max_acceleration_rad_s2.cwiseMax(from_.a_rad_s2.cwiseAbs());
  jerk_ = limits_.max_jerk_rad_s3;
  lower_ = limits_.lower_rad.cwiseMin(from_.q_rad);
  upper_ = limits_.upper_rad.cwiseMax(from_.q_rad);
  for (const Joints& waypoint : waypoints_) {
    lower_ = lower_.cwiseMin(waypoint);
    upper_ = upper_.cwiseMax(waypoint);
  }
}

/// A duration below which the piece cannot keep the limits.
double Trajectory::Timing::shortest(std::size_t piece) const {
  const Joints way = waypoints_[piece] - (piece == 0 ? from_.q_rad : waypoints_[piece - 1]);
  const bool from_rest = from_.v_rad_s.isZero(0.0) && from_.a_rad_s2.isZero(0.0);
  if (from_rest && waypoints_.size() == 1)
    return std::max({kPeakSpeed * largestRatio(way, limits_.max_speed_rad_s),
                     std::sqrt(kPeakAcceleration * largestRatio(way, limits_.max_acceleration_rad_s2)),
                     std::cbrt(kPeakJerk * largestRatio(way, limits_.max_jerk_rad_s3)), kShortestPiece_s});
  const double slowing = piece == 0 ? largestRatio(from_.v_rad_s, acceleration_) : 0.0;
  return std::max({largestRatio(way, speed_), slowing, kShortestPiece_s});
}

/// The first stretch whose excess is `allowed`, 0 if none; `best` is the least excess met.
double Trajectory::Timing::firstWithin(double allowed, double stretch, double& best) {
  for (int i = 0; i < kMaxStretches; ++i, stretch *= kStretch) {
    const double excess = excessAt(stretch);
    best = std::min(best, excess);
    if (excess <= allowed) return stretch;
  }
  return 0.0;
}

double Trajectory::Timing::refined(double too_short, double long_enough, double allowed) {
  constexpr int halvings = 10;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (too_short + long_enough);
    (excessAt(middle) <= allowed ? long_enough : too_short) = middle;
  }
  return long_enough;
}

void Trajectory::Timing::build(double stretch) {
  MotionState begin = from_;
  for (std::size_t k = 0; k < waypoints_.size(); ++k) {
    Stretch& piece = pieces_[k];
    piece.duration_s = stretch * shortest_s_[k];
    const MotionState end{waypoints_[k], passingSpeed(k, stretch), Joints::Zero(from_.q_rad.size())};
    for (Eigen::Index j = 0; j < from_.q_rad.size(); ++j)
      piece.joints[static_cast<std::size_t>(j)] =
          quinticBetween({begin.q_rad[j], begin.v_rad_s[j], begin.a_rad_s2[j]},
                         {end.q_rad[j], end.v_rad_s[j], end.a_rad_s2[j]}, piece.duration_s);
    begin = end;
  }
}

/// Harmonic mean of the slopes on both sides, zero where a joint turns back: does not overshoot.
Joints Trajectory::Timing::passingSpeed(std::size_t k, double stretch) const {
  Joints v = Joints::Zero(from_.q_rad.size());
  if (k + 1 == waypoints_.size()) return v;
  const Joints before =
      (waypoints_[k] - (k == 0 ? from_.q_rad : waypoints_[k - 1])) / (stretch * shortest_s_[k]);
  const Joints after = (waypoints_[k + 1] - waypoints_[k]) / (stretch * shortest_s_[k + 1]);
  for (Eigen::Index j = 0; j < v.size(); ++j)
    if (before[j] * after[j] > 0.0) v[j] = 2.0 * before[j] * after[j] / (before[j] + after[j]);
  return v;
}

/// 1 and less: within all limits.
double Trajectory::Timing::excessAt(double stretch) {
  build(stretch);
  double excess = 0.0;
  for (std::size_t k = 0; k < waypoints_.size(); ++k)
    for (Eigen::Index j = 0; j < from_.q_rad.size(); ++j) excess = std::max(excess, excessOf(k, j));
  return excess;
}

double Trajectory::Timing::excessOf(std::size_t k, Eigen::Index j) const {
  const Stretch& piece = pieces_[k];
  const MotionRanges ranges = rangesOf(piece.joints[static_cast<std::size_t>(j)], piece.duration_s);
  const double outside = std::max(lower_[j] - ranges.position.least, ranges.position.most - upper_[j]);
  return std::max({magnitude(ranges.speed) / speed_[j], magnitude(ranges.acceleration) / acceleration_[j],
                   magnitude(ranges.jerk) / jerk_[j],
                   outside > kTolerance ? 1.0 + outside / kOutsideScale_rad : 0.0});
}

Trajectory Trajectory::through(const MotionState& from, std::span<const Joints> waypoints, TimePoint start,
                               const MotionLimits& limits, Seconds at_least) {
  assert(!waypoints.empty() && waypoints.size() <= kMaxPieces);
  Timing timing(from, waypoints, limits);
  timing.fastest(at_least);
  Trajectory trajectory(from.q_rad.size(), start);
  timing.appendTo(trajectory);
  return trajectory;
}

}  // namespace mirrorarm::robot
