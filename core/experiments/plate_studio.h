#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::experiments {

/// A dot plate before simulated cameras, with the bench's lens blur and sensor noise.
class PlateStudio {
 public:
  /// `plate` is a dot plate. Equal seeds give equal images.
  PlateStudio(const camera::StereoRig& rig, const calibration::Board& plate, std::uint64_t seed);

  /// What both cameras see of the plate at `X_CM`; nothing where either does not find it.
  [[nodiscard]] std::optional<calibration::BoardView> take(const RigidTransform& X_CM,
                                                           const std::string& name);

 private:
  calibration::Board plate_;
  std::vector<simulation::Patch> discs_M_;
  simulation::StereoRenderer renderer_;
  std::uint64_t seed_;
  std::uint64_t taken_ = 0;
};

}  // namespace mirrorarm::experiments
