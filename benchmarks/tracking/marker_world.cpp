#include "benchmarks/tracking/marker_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/geometry/rigid_fit.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;

constexpr double kRadius_m = 0.045;
constexpr double kLength_m = 0.150;
constexpr double kLeastDistance_m = 0.020;
constexpr double kStrangersReach_m = 0.150;

Vector3d anywhere(double reach_m, TrialRandom& random) {
  return {random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m),
          random.uniform(-reach_m, reach_m)};
}

Vector3d onHalfCylinder(TrialRandom& random) {
  const double angle = random.uniform(0.0, std::numbers::pi);
  return {random.uniform(0.0, kLength_m), kRadius_m * std::cos(angle), kRadius_m * std::sin(angle)};
}

template <class Value>
void shuffle(std::vector<Value>& values, TrialRandom& random) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[static_cast<std::size_t>(random.index(static_cast<int>(i)))]);
}

std::vector<Origin> seenMarkers(std::span<const Placed> bodies, TrialRandom& random) {
  std::vector<Origin> seen;
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body) {
    const Placed& placed = bodies[static_cast<std::size_t>(body)];
    std::vector<Origin> markers;
    for (int marker = 0; marker < static_cast<int>(placed.markers_T->size()); ++marker)
      markers.push_back({body, marker});
    shuffle(markers, random);
    seen.insert(seen.end(), markers.begin(), markers.begin() + placed.visible);
  }
  return seen;
}

}  // namespace

Layout randomLayout(int markers, TrialRandom& random) {
  Layout layout;
  while (static_cast<int>(layout.size()) < markers) {
    const Vector3d next = onHalfCylinder(random);
    if (std::ranges::all_of(layout, [&](const Vector3d& p) { return (p - next).norm() >= kLeastDistance_m; }))
      layout.push_back(next);
  }
  const Vector3d middle = centroid(layout);
  for (Vector3d& p : layout) p -= middle;
  return layout;
}

RigidTransform randomPose(TrialRandom& random, double aside_m) {
  const Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  return makeTransform(q, Vector3d(random.uniform(-aside_m, aside_m), random.uniform(-aside_m, aside_m),
                                   random.uniform(0.4, 0.6)));
}

MarkerScene look(std::span<const Placed> bodies, int strangers, TrialRandom& random,
                 const Vector3d& middle_C) {
  MarkerScene scene;
  scene.origins = seenMarkers(bodies, random);
  scene.origins.insert(scene.origins.end(), static_cast<std::size_t>(strangers), Origin{});
  shuffle(scene.origins, random);
  for (const auto& [body, marker] : scene.origins) {
    mirrorarm::tracking::CloudPoint point;
    if (body >= 0) {
      const Placed& placed = bodies[static_cast<std::size_t>(body)];
      point.p_C = placed.X_CT * (*placed.markers_T)[static_cast<std::size_t>(marker)];
    } else {
      const auto near = static_cast<int>(bodies.size());
      const Vector3d& about =
          near == 0 ? middle_C : bodies[static_cast<std::size_t>(random.index(near))].X_CT.translation();
      point.p_C = about + anywhere(kStrangersReach_m, random);
    }
    point.p_C += kSensorNoise_m * Vector3d(random.normal(), random.normal(), random.normal());
    point.covariance_m2 = kSensorNoise_m * kSensorNoise_m * Eigen::Matrix3d::Identity();
    scene.cloud.push_back(point);
  }
  return scene;
}

bool fixesTurn(const MarkerScene& scene, int body, const Layout& markers_T) {
  constexpr double most_turn = 0.5 * std::numbers::pi / 180.0;
  std::vector<Vector3d> seen;
  for (const Origin& origin : scene.origins)
    if (origin.body == body) seen.push_back(markers_T[static_cast<std::size_t>(origin.marker)]);
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : seen) mean += p / static_cast<double>(seen.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : seen) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter, Eigen::EigenvaluesOnly);
  const double beside_line = std::sqrt(axes.eigenvalues()[0] + axes.eigenvalues()[1]);
  return kSensorNoise_m <= most_turn * beside_line;
}

bool isRight(const MarkerScene& scene, int body, const RigidTransform& X_CT, const RigidTransform& found_CT,
             std::span<const int> point_of_marker) {
  constexpr double most_shift_m = 0.0015, most_turn = 2.0 * std::numbers::pi / 180.0;
  for (int marker = 0; marker < static_cast<int>(point_of_marker.size()); ++marker) {
    const int point = point_of_marker[static_cast<std::size_t>(marker)];
    if (point < 0) continue;
    const Origin& origin = scene.origins[static_cast<std::size_t>(point)];
    if (origin.body != body || origin.marker != marker) return false;
  }
  return (found_CT.translation() - X_CT.translation()).norm() < most_shift_m &&
         angleBetween(found_CT, X_CT) < most_turn;
}

}  // namespace mirrorarm::benchmarks::tracking
