#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/cloud_point.h"
#include "core/tracking/consistency.h"
#include "core/tracking/gated_pairs.h"
#include "core/tracking/motion_predictor.h"
#include "core/tracking/pose_estimator.h"
#include "core/tracking/shape.h"
#include "core/tracking/shape_fit.h"
#include "core/tracking/softassign.h"

namespace mirrorarm::tracking {

struct WarmSettings {
  SoftassignSettings softassign;
  double gate_sigmas = 5.0;  ///< how far from where it is expected a marker is looked for
  double slack_m = 0.0003;   ///< that nothing else accounts for, standard deviation
  double max_rms_m = 0.003;  ///< of an accepted fit (paper: 3 mm)
  int min_matched = 3;       ///< markers that an accepted fit needs
};

/// Lays a shape into a cloud when about where it is is known: each marker takes a point inside its gate,
/// which prediction, shape and sensor make together; where several fit, the paper's softassign decides; what
/// does not agree with the others on distances is dropped (a clique); then the pose of greatest likelihood,
/// with which all is done again inside the much narrower gates it gives, until the pairs stay. Matches that
/// the estimate tells to be outliers are no matches. Few matches among many points in wide gates prove
/// nothing. One thread; keeps its buffers. Coordinates must be
/// finite.
class WarmRegistration {
 public:
  explicit WarmRegistration(const WarmSettings& settings = {});

  /// The answer stays good until the next call.
  [[nodiscard]] const ShapeFit& run(const Shape& shape, std::span<const CloudPoint> cloud,
                                    const UncertainPose& predicted);

 private:
  void pair(const Shape& shape, std::span<const CloudPoint> cloud, const UncertainPose& expected, bool first);
  void softassign(const Shape& shape, std::span<const CloudPoint> cloud, const UncertainPose& expected);
  void collectCandidates(const Shape& shape, std::span<const CloudPoint> cloud);
  void dropInconsistent(const Shape& shape, std::span<const CloudPoint> cloud, bool first);
  void estimate(const Shape& shape, std::span<const CloudPoint> cloud, const RigidTransform& start);
  void dropOutliers();
  [[nodiscard]] LostReason verdict(int gated);
  [[nodiscard]] int countMatched() const;
  [[nodiscard]] double slack_m() const;
  [[nodiscard]] double chance() const;

  WarmSettings settings_;
  ShapeFit result_;
  GatedPairs pairs_;
  ConsistencyCheck consistency_;
  PoseEstimator estimator_;
  Softassign softassign_;
  double gate_m_ = 0.0;  ///< radius of the first gates
  int candidates_ = 0;   ///< pairs inside them
  std::vector<int> before_;
  std::vector<MarkerMatch> matches_;
  std::vector<std::size_t> marker_of_match_;
  std::vector<Eigen::Vector3d> x_, y_;  ///< what softassign sees: markers that count, gated points
  std::vector<std::size_t> marker_of_x_;
  std::vector<int> point_of_y_;
};

}  // namespace mirrorarm::tracking
