#include "core/robot/trajectory.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::robot {

void Trajectory::JointMotion::append(double duration_s, const Polynomial& position) noexcept {
  assert(piece_count < kMaxPieces);
  pieces[static_cast<std::size_t>(piece_count++)] = {duration_s, position};
}

double Trajectory::JointMotion::duration() const noexcept {
  double sum = 0.0;
  for (int k = 0; k < piece_count; ++k) sum += pieces[static_cast<std::size_t>(k)].duration_s;
  return sum;
}

EndState Trajectory::JointMotion::at(double t) const noexcept {
  std::size_t k = 0;
  const auto last = static_cast<std::size_t>(piece_count - 1);
  while (k < last && t >= pieces[k].duration_s) t -= pieces[k++].duration_s;
  const Piece& piece = pieces[k];
  if (t >= piece.duration_s) return {valueAt(piece.position, piece.duration_s), 0.0, 0.0};
  const Polynomial speed = derivative(piece.position);
  return {valueAt(piece.position, t), valueAt(speed, t), valueAt(derivative(speed), t)};
}

Trajectory Trajectory::rest(const Joints& q, TimePoint start) {
  Trajectory trajectory(q.size(), start);
  for (Eigen::Index j = 0; j < q.size(); ++j) trajectory.joint(j).append(0.0, {q[j]});
  return trajectory;
}

Trajectory Trajectory::quintic(const MotionState& from, const Joints& goal, TimePoint start,
                               const MotionLimits& limits, Seconds at_least) {
  return through(from, std::span(&goal, 1), start, limits, at_least);
}

MotionState Trajectory::at(TimePoint time) const noexcept {
  assert(valid());
  const double t = std::max(0.0, secondsBetween(start_, time));
  MotionState state{Joints(joint_count_), Joints(joint_count_), Joints(joint_count_)};
  for (Eigen::Index j = 0; j < joint_count_; ++j) {
    const EndState now = joint(j).at(t);
    state.q_rad[j] = now.q;
    state.v_rad_s[j] = now.v;
    state.a_rad_s2[j] = now.a;
  }
  return state;
}

Seconds Trajectory::duration() const noexcept {
  double longest = 0.0;
  for (Eigen::Index j = 0; j < joint_count_; ++j) longest = std::max(longest, joint(j).duration());
  return Seconds(longest);
}

Joints Trajectory::goal() const noexcept {
  assert(valid());
  Joints q(joint_count_);
  for (Eigen::Index j = 0; j < joint_count_; ++j) q[j] = joint(j).at(joint(j).duration()).q;
  return q;
}

}  // namespace mirrorarm::robot
