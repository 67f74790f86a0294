#include "core/calibration/timed_path.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kLongestGapInIntervals = 4.5;

double medianInterval_s(std::span<const TimedPose> poses) {
  assert(poses.size() >= 2);
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < poses.size(); ++i) intervals_s.push_back(poses[i].time_s - poses[i - 1].time_s);
  return median(std::move(intervals_s));
}

}  // namespace

TimedPath::TimedPath(std::span<const TimedPose> poses)
    : poses_(poses), interval_s_(medianInterval_s(poses)) {}

std::optional<RigidTransform> TimedPath::at(double time_s) const {
  const auto after = std::upper_bound(poses_.begin(), poses_.end(), time_s,
                                      [](double time, const TimedPose& pose) { return time < pose.time_s; });
  if (after == poses_.begin() || after == poses_.end()) return std::nullopt;
  const auto before = after - 1;
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > kLongestGapInIntervals * interval_s_) return std::nullopt;
  return interpolate(before->X, after->X, (time_s - before->time_s) / gap_s);
}

std::optional<SmallMotion> TimedPath::velocityAt(double time_s, double half_width_s) const {
  const auto before = at(time_s - half_width_s), after = at(time_s + half_width_s);
  const auto now = at(time_s);
  if (!before || !now || !after) return std::nullopt;
  SmallMotion velocity;
  velocity << rotationVector(before->linear().transpose() * after->linear()),
      now->linear().transpose() * (after->translation() - before->translation());
  return velocity / (2.0 * half_width_s);
}

}  // namespace mirrorarm::calibration
