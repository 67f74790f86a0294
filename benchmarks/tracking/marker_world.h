#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "benchmarks/trial_random.h"
#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"

namespace mirrorarm::benchmarks::tracking {

using Layout = std::vector<Eigen::Vector3d>;

/// Noise of a measured point in each direction [m].
inline constexpr double kSensorNoise_m = 0.00015;

/// Markers on half a cylinder of 45 mm radius and 150 mm length, no two nearer than 20 mm, about their
/// centroid: the size of a forearm.
[[nodiscard]] Layout randomLayout(int markers, TrialRandom& random);

/// Any rotation, in front of the camera, at most `aside_m` from its axis and 0.4 to 0.6 m away.
[[nodiscard]] RigidTransform randomPose(TrialRandom& random, double aside_m = 0.1);

/// A body in view; which of its markers are seen is left to chance.
struct Placed {
  const Layout* markers_T = nullptr;
  RigidTransform X_CT = RigidTransform::Identity();
  int visible = 0;
};

/// What a measured point truly is; -1 for a stranger.
struct Origin {
  int body = -1;
  int marker = -1;
};

/// A measured cloud in no order.
struct MarkerScene {
  std::vector<mirrorarm::tracking::CloudPoint> cloud;
  std::vector<Origin> origins;  ///< one a point
};

/// The bodies' visible markers with sensor noise, and `strangers` anywhere within 150 mm a side of a body
/// (each of a body chosen by chance; of `middle_C` when there are none).
[[nodiscard]] MarkerScene look(std::span<const Placed> bodies, int strangers, TrialRandom& random,
                               const Eigen::Vector3d& middle_C = {0.0, 0.0, 0.5});

/// False when the seen markers of `body` lie so near to one line that noise alone turns even the best fit
/// about it by more than 0.5 degrees (standard deviation).
[[nodiscard]] bool fixesTurn(const MarkerScene& scene, int body, const Layout& markers_T);

/// Right is what is less than 2 degrees and 1.5 mm off, with every marker that has a point on its own one.
[[nodiscard]] bool isRight(const MarkerScene& scene, int body, const RigidTransform& X_CT,
                           const RigidTransform& found_CT, std::span<const int> point_of_marker);

}  // namespace mirrorarm::benchmarks::tracking
