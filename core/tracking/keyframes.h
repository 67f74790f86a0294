#pragma once

#include <span>
#include <vector>

#include "core/tracking/bundle_adjustment.h"

namespace mirrorarm::tracking {

/// The frames of a lesson that are kept for the adjustment: bounded, in their order, as differently turned as
/// there were. One thread.
class Keyframes {
 public:
  static constexpr std::size_t kMax = 400;

  void clear() { frames_.clear(); }
  /// Keeps a frame; when there is no room the earlier of the two frames that are turned most alike goes.
  void add(const RigidTransform& X_CT, std::span<const Sighting> sightings);

  [[nodiscard]] std::span<const NetworkFrame> all() const { return frames_; }
  void correct(std::size_t frame, const RigidTransform& X_CT) { frames_[frame].X_CT = X_CT; }

 private:
  void dropMostAlike();

  std::vector<NetworkFrame> frames_;
};

}  // namespace mirrorarm::tracking
