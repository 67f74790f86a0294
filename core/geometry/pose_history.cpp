#include "core/geometry/pose_history.h"

namespace mirrorarm {

void PoseHistory::add(TimePoint time, const RigidTransform& X) noexcept {
  if (size_ > 0 && time <= entry(size_ - 1).time) return;
  entries_[next_] = {time, X};
  next_ = (next_ + 1) % entries_.size();
  if (size_ < entries_.size()) ++size_;
}

std::optional<RigidTransform> PoseHistory::at(TimePoint time, Seconds tolerance) const {
  if (size_ == 0) return std::nullopt;
  const Entry& oldest = entry(0);
  const Entry& newest = entry(size_ - 1);
  if (time < oldest.time) return oldest.time - time <= tolerance ? std::optional(oldest.X) : std::nullopt;
  if (time >= newest.time) return time - newest.time <= tolerance ? std::optional(newest.X) : std::nullopt;
  std::size_t low = 0, high = size_ - 1;  // entry(low).time <= time < entry(high).time
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (entry(middle).time <= time ? low : high) = middle;
  }
  const Entry& before = entry(low);
  const Entry& after = entry(high);
  return interpolate(before.X, after.X, Seconds(time - before.time) / Seconds(after.time - before.time));
}

}  // namespace mirrorarm
