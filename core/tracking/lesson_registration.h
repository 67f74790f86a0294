#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/tracking/constellation_search.h"
#include "core/tracking/running_model.h"
#include "core/tracking/warm_registration.h"

namespace mirrorarm::tracking {

/// Finds the body that is being taught in the next cloud of the lesson: near where its motion from frame to
/// frame puts it, else anywhere. One thread; keeps its buffers.
class LessonRegistration {
 public:
  struct Fit {
    RigidTransform X_CT = RigidTransform::Identity();
    double rms_m = 0.0;
  };

  LessonRegistration(const SoftassignSettings& softassign, double max_rms_m);

  /// Where the body was in the cloud that the lesson began with.
  void begin(const RigidTransform& X_CT);
  /// Nothing when the cloud does not show enough of the points, or does not fit them.
  std::optional<Fit> run(std::span<const RunningModel::Point> points, std::span<const CloudPoint> cloud);

 private:
  void describe(std::span<const RunningModel::Point> points);
  [[nodiscard]] UncertainPose expected() const;
  [[nodiscard]] const SearchResult& search(std::span<const CloudPoint> cloud);

  WarmSettings settings_;
  WarmRegistration warm_;
  ConstellationSearch search_;
  RigidTransform X_CT_ = RigidTransform::Identity();    ///< at the last cloud that fitted
  RigidTransform step_T_ = RigidTransform::Identity();  ///< from the one before it to it
  std::vector<Eigen::Vector3d> markers_T_;
  std::vector<Eigen::Matrix3d> covariance_m2_;
};

}  // namespace mirrorarm::tracking
