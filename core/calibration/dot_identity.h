#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/grid_pixels.h"

namespace mirrorarm::calibration {

/// A dot of a lattice whose size is known.
struct SizedDot {
  Place place = Place::Zero();
  bool is_large = false;
};

/// A lattice's place on the pattern: place on the plate = turn * place on the lattice + shift.
struct LatticePlace {
  Eigen::Matrix2i turn = Eigen::Matrix2i::Identity();  ///< by quarters
  Eigen::Vector2i shift = Eigen::Vector2i::Zero();
  bool is_larger = false;  ///< the plate goes on beyond the wished one

  [[nodiscard]] Place onPlate(const Place& place) const { return turn * place + shift; }
};

/// Which dots of the pattern `dots` are, by their sizes. A few may be wrong, and a few may lie beyond the
/// plate: lights that are no dots. Nothing when no place fits, or when another one fits nearly as well, so
/// that two dots of the wrong size could not have made it.
[[nodiscard]] std::optional<LatticePlace> placeOnPlate(std::span<const SizedDot> dots, const Board& plate);

}  // namespace mirrorarm::calibration
