#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/association.h"
#include "core/tracking/softassign.h"

namespace mirrorarm::benchmarks::tracking {

/// What a method with a rigid model says of one frame.
struct RigidAnswer {
  bool accepted = false;
  RigidTransform X_CT = RigidTransform::Identity();
  std::vector<int> point_of_marker;  ///< -1 for none
};

/// The paper's rule: softassign from a start, accepted with 50 % of the markers and 3 mm rms.
class PaperRule {
 public:
  [[nodiscard]] RigidAnswer track(std::span<const Eigen::Vector3d> markers_T,
                                  std::span<const Eigen::Vector3d> cloud_C, const RigidTransform& start_CT);

 private:
  mirrorarm::tracking::Softassign softassign_;
};

/// The plain one: nearest neighbours within 20 mm and Kabsch's pose in turn from a start; accepts any fit of
/// 3 markers.
class PlainFit {
 public:
  [[nodiscard]] RigidAnswer track(std::span<const Eigen::Vector3d> markers_T,
                                  std::span<const Eigen::Vector3d> cloud_C, const RigidTransform& start_CT);

 private:
  mirrorarm::tracking::Association association_;
};

}  // namespace mirrorarm::benchmarks::tracking
