#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// A taught set of markers on one body, in its own frame T: origin at the markers' centroid when it was
/// taught.
struct Target {
  std::string name;
  double marker_diameter_m = 0.007;
  std::vector<Eigen::Vector3d> markers_T;              ///< centres [m]
  std::vector<Eigen::Matrix3d> markers_covariance_m2;  ///< one a marker, or empty when unknown
};

}  // namespace mirrorarm::tracking
