#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/shape_fit.h"
#include "core/tracking/softassign.h"

namespace mirrorarm::tracking {

/// The paper's parameters (section 3.1).
struct PaperSettings {
  SoftassignSettings softassign;
  double min_marker_share = 0.5;      ///< markers that an accepted fit needs (paper: 50 %)
  double max_rms_m = 0.003;           ///< of an accepted fit (paper: 3 mm)
  int rejections_before_reteach = 4;  ///< "multiple in a row"
};

/// The paper's registration, whole, for comparison: softassign through its full schedule from the last pose,
/// or from the clouds' centroids when there is none; the pose by dual quaternions, all pairs weighing the
/// same; accepted by share of markers and misfit. It does not know which points share a disc. Keeps its
/// buffers; one thread. Source: paper sections 2.3 and 3.1.
class PaperRegistration {
 public:
  explicit PaperRegistration(const PaperSettings& settings = {}) : settings_(settings) {}

  /// Coordinates must be finite. The answer stays good until the next call.
  [[nodiscard]] const ShapeFit& run(std::span<const Eigen::Vector3d> markers_T,
                                    std::span<const CloudPoint> cloud,
                                    const std::optional<RigidTransform>& last_X_CT);

 private:
  void keepMatches(std::span<const Eigen::Vector3d> markers_T, std::span<const CloudPoint> cloud);
  [[nodiscard]] LostReason verdict(std::size_t markers) const;

  PaperSettings settings_;
  ShapeFit fit_;
  Softassign softassign_;
  std::vector<Eigen::Vector3d> points_C_, matched_T_, matched_C_;
  std::vector<Eigen::Matrix3d> matched_covariance_;
};

}  // namespace mirrorarm::tracking
