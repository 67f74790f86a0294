#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/association.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/deviation_fit.h"
#include "core/tracking/softassign.h"

namespace mirrorarm::tracking {

/// Finds the markers of a shape that has changed as far as skin moves (20 mm), near a known pose: the paper's
/// softassign first, then a robust pose by those that kept their places best, then along with what the
/// neighbours of each marker have moved, for a sleeve moves together. Keeps its buffers.
class WideMatch {
 public:
  struct Body {
    std::span<const Eigen::Vector3d> shape_T;  ///< [m]
    std::span<const char> present;
    std::span<const double> variances_m2;  ///< of each marker, beyond the sensor
  };
  /// False when too few markers are found or they lie too far off.
  [[nodiscard]] bool run(const Body& body, const RigidTransform& X_CT, std::span<const CloudPoint> cloud,
                         std::span<const char> taken);

  [[nodiscard]] const RigidTransform& pose() const { return X_CT_; }
  [[nodiscard]] std::span<const int> pointOfMarker() const { return point_of_marker_; }

 private:
  void collect(const Body& body, std::span<const CloudPoint> cloud, std::span<const char> taken);
  void assignSoftly();
  void pair(double gate_m);
  void fit(const Body& body);
  void followNeighbours(const Body& body);

  std::vector<std::size_t> markers_, points_;  ///< what is looked at, of all
  std::vector<Eigen::Vector3d> places_T_, points_C_;
  std::vector<SeenDiscs> discs_;
  std::vector<int> pairs_, point_of_marker_;
  std::vector<SeenMarker> seen_;
  Softassign softassign_;
  Association association_;
  DeviationFit fit_;
  DeviationModes none_;
  RigidTransform X_CT_ = RigidTransform::Identity();
};

}  // namespace mirrorarm::tracking
