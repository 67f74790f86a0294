#pragma once

#include <span>
#include <vector>

#include "core/tracking/cloud_point.h"
#include "core/tracking/motion_predictor.h"
#include "core/tracking/one_to_one.h"
#include "core/tracking/shape.h"

namespace mirrorarm::tracking {

/// How far from where it is expected a marker may be [m], of all markers that count the farthest.
[[nodiscard]] double gateRadius(const Shape& shape, const UncertainPose& expected, double gate_sigmas,
                                double slack_m);

/// Which points of a cloud may be which markers of a shape, given about where the shape is. Keeps its
/// buffers.
class GatedPairs {
 public:
  /// Pairs not farther apart than `gate_sigmas` of pose, shape, sensor and `slack_m` together; their misfits
  /// are squared distances in sigmas of what is expected.
  void find(const Shape& shape, std::span<const CloudPoint> cloud, const UncertainPose& expected,
            double gate_sigmas, double slack_m);

  [[nodiscard]] std::span<const CandidatePair> all() const { return pairs_; }
  /// The gateRadius() of the last find().
  [[nodiscard]] double radius_m() const { return radius_m_; }
  /// No marker has two points, no point or disc two markers: there is nothing to decide.
  [[nodiscard]] bool areUnique(std::span<const CloudPoint> cloud) const;
  /// Gives each marker its likeliest point, the likeliest pairs first, one-to-one also in discs; -1 for none.
  void assign(std::span<const CloudPoint> cloud, std::vector<int>& point_of_marker);

 private:
  void addPairsOf(int marker, const Eigen::Vector3d& expected_C, const Eigen::Matrix3d& covariance_C_m2,
                  std::span<const CloudPoint> cloud, double gate_sigmas);

  std::vector<CandidatePair> pairs_;
  std::size_t markers_ = 0;
  double radius_m_ = 0.0;
};

}  // namespace mirrorarm::tracking
