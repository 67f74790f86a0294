#pragma once

#include <span>
#include <vector>

#include "core/calibration/grid_pixels.h"
#include "core/calibration/sighting.h"

namespace mirrorarm::calibration {

/// A disc on a lattice.
struct PlacedDisc {
  Place place = Place::Zero();
  std::size_t disc = 0;                                    ///< index into the discs
  Eigen::Matrix2d steps_px = Eigen::Matrix2d::Identity();  ///< see LocalMap
};

/// A disc's diameter in steps of the lattice, by its outline and the steps around it.
[[nodiscard]] double diameterOf(const Eigen::Matrix2d& shape_px2, const Eigen::Matrix2d& steps_px);

/// What belongs to a lattice, in its steps.
struct LatticeLimits {
  double least_diameter = 0.05;
  double most_diameter = 1.4;  ///< marks of some plates reach beyond their cells
  double most_inside =
      0.05;  ///< that a disc may stray from where its surroundings say, neighbours all around
  double most_at_rim = 0.08;  ///< the same at a rim
  [[nodiscard]] bool holds(double diameter) const {
    return diameter > least_diameter && diameter < most_diameter;
  }
};

/// The largest square lattice that discs of one image form (`pixel` and `shape_px2` are read), lights beside
/// and between left out, gaps crossed by their sides. A disc's outline tells how its surroundings are
/// foreshortened, so that the neighbours are known however flat the board is seen, through any lens; every
/// disc kept lies where those around it say. Places count from an arbitrary disc, in an arbitrary one of four
/// turns, never mirrored: rows follow columns as y follows x in the image. Empty when there is none of at
/// least 6 discs.
[[nodiscard]] std::vector<PlacedDisc> largestLattice(std::span<const SeenPoint> discs,
                                                     const LatticeLimits& limits);

}  // namespace mirrorarm::calibration
