#include "benchmarks/tracking/skin_methods.h"

#include "core/geometry/rigid_fit.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;

constexpr double kPaperShare = 0.5;
constexpr double kPaperRms_m = 0.003;
constexpr double kPaperStart_mm = 10.0;  // how far markers may lie from where the start puts them
constexpr double kNearest_m = 0.020;
constexpr int kRounds = 10;

}  // namespace

RigidAnswer PaperRule::track(std::span<const Vector3d> markers_T, std::span<const Vector3d> cloud_C,
                             const RigidTransform& start_CT) {
  mirrorarm::tracking::SoftassignSettings settings;
  settings.beta_start = 0.5 / (kPaperStart_mm * kPaperStart_mm);
  const auto& found = softassign_.run(markers_T, cloud_C, settings, start_CT);
  const bool enough = found.matched >= kPaperShare * static_cast<double>(markers_T.size());
  return {enough && found.rms_m < kPaperRms_m, found.X_YX, found.y_of_x};
}

RigidAnswer PlainFit::track(std::span<const Vector3d> markers_T, std::span<const Vector3d> cloud_C,
                            const RigidTransform& start_CT) {
  RigidAnswer answer{false, start_CT, {}};
  std::vector<Vector3d> x, y;
  for (int round = 0; round < kRounds; ++round) {
    if (association_.pair(markers_T, cloud_C, answer.X_CT, kNearest_m, answer.point_of_marker) < 3)
      return answer;
    x.clear();
    y.clear();
    for (std::size_t i = 0; i < markers_T.size(); ++i) {
      if (answer.point_of_marker[i] < 0) continue;
      x.push_back(markers_T[i]);
      y.push_back(cloud_C[static_cast<std::size_t>(answer.point_of_marker[i])]);
    }
    answer.X_CT = fitByKabsch(x, y);
  }
  answer.accepted = true;
  return answer;
}

}  // namespace mirrorarm::benchmarks::tracking
