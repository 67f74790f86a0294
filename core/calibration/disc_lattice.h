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

/// The largest square lattice that discs of one image form (`pixel` and `shape_px2` are read), lights beside
/// and between left out, gaps crossed by their sides. A disc's outline tells how its surroundings are
/// foreshortened, so that the neighbours are known however flat the board is seen, through any lens; every
/// disc kept lies where those around it say. Places count from an arbitrary disc, in an arbitrary one of four
/// turns, never mirrored: rows follow columns as y follows x in the image. Empty when there is none of at
/// least 6 discs.
[[nodiscard]] std::vector<PlacedDisc> largestLattice(std::span<const SeenPoint> discs);

}  // namespace mirrorarm::calibration
