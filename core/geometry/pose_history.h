#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm {

/// The last poses of one frame with their times, asked at any time between: so a camera image meets the
/// flange pose of its own exposure. One thread; does not allocate.
class PoseHistory {
 public:
  /// Adds a pose. A time not after the newest one is ignored, so that a repeated reading does no harm.
  void add(TimePoint time, const RigidTransform& X) noexcept;

  /// The pose at `time`, interpolated. Nothing when `time` lies outside what is kept, except that up to
  /// `tolerance` past either end the end's pose is given.
  [[nodiscard]] std::optional<RigidTransform> at(TimePoint time, Seconds tolerance = Seconds(0.0)) const;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  struct Entry {
    TimePoint time{};
    RigidTransform X = RigidTransform::Identity();
  };
  [[nodiscard]] const Entry& entry(std::size_t i) const noexcept {
    return entries_[(next_ + entries_.size() - size_ + i) % entries_.size()];
  }
  std::array<Entry, 1024> entries_{};
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace mirrorarm
