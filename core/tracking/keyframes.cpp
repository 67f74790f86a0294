#include "core/tracking/keyframes.h"

#include <cmath>

namespace mirrorarm::tracking {

void Keyframes::add(const RigidTransform& X_CT, std::span<const Sighting> sightings) {
  if (frames_.size() == kMax) dropMostAlike();
  frames_.push_back({X_CT, {sightings.begin(), sightings.end()}});
}

void Keyframes::dropMostAlike() {
  std::vector<Eigen::Vector4d> turns;
  for (const auto& frame : frames_) turns.push_back(rotationOf(frame.X_CT).coeffs());
  std::size_t earlier = 0;
  double most_alike = -1.0;
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (std::size_t j = i + 1; j < turns.size(); ++j) {
      const double likeness = std::abs(turns[i].dot(turns[j]));
      if (likeness <= most_alike) continue;
      most_alike = likeness;
      earlier = i;
    }
  frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(earlier));
}

}  // namespace mirrorarm::tracking
