#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/sighting.h"
#include "core/camera/camera_model.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// One image's points, the lens that took them and where the board stood to it. Refers to both.
struct PosedSighting {
  const camera::CameraModel& camera;
  RigidTransform X_KM;  ///< board in this camera
  const Sighting& sighting;
};

/// Radii of a board's discs, one a point [m], from the areas of their outlines: the median over the images,
/// then over all discs of like size (a dot plate has two). 0 for corners, and for discs that no image shows.
[[nodiscard]] std::vector<double> discRadii(std::span<const Eigen::Vector3d> board,
                                            std::span<const PosedSighting> images);

/// The sighting with every disc's outline centre replaced by the image of the disc's own centre (see
/// vision::centreBias); what belongs to no disc, or to one without a radius, stays.
[[nodiscard]] Sighting physicalCentres(const PosedSighting& image, std::span<const Eigen::Vector3d> board,
                                       std::span<const double> radii_m);

}  // namespace mirrorarm::calibration
