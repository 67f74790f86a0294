#include "app/cli/pose_audit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/common/quantile.h"
#include "core/geometry/rigid_fit.h"

namespace mirrorarm::cli {
namespace {

/// A disc further than this from a tracked marker is another disc.
constexpr double kSameDisc_m = 0.010;

std::optional<Eigen::Vector3d> discNear(const Eigen::Vector3d& p_B, std::span<const simulation::Disc> discs) {
  const auto nearest = std::min_element(discs.begin(), discs.end(), [&](const auto& one, const auto& other) {
    return (one.p_B - p_B).squaredNorm() < (other.p_B - p_B).squaredNorm();
  });
  if (nearest == discs.end() || (nearest->p_B - p_B).norm() > kSameDisc_m) return std::nullopt;
  return nearest->p_B;
}

}  // namespace

void PoseAudit::look(const station::Snapshot& snapshot) {
  if (!snapshot.frame || snapshot.frame->frame.sequence < next_sequence_ || snapshot.frame->targets.empty())
    return;
  const auto& seen = *snapshot.frame;
  next_sequence_ = seen.frame.sequence + 1;
  if (seen.targets.front().status != tracking::TrackStatus::kTracked) return;
  const auto truth = bench_.truthAt(seen.frame.exposed_at);
  const RigidTransform X_BC = truth.X_BF * bench_.X_FC();
  const RigidTransform X_BT = X_BC * seen.targets.front().X_CT;
  std::vector<Eigen::Vector3d> model_T, discs_B;
  for (const auto& marker_T : seen.target->markers_T) {
    const auto disc_B = discNear(X_BT * marker_T, truth.discs);
    if (!disc_B) continue;
    model_T.push_back(marker_T);
    discs_B.push_back(*disc_B);
  }
  if (model_T.size() < 3) return;
  const RigidTransform X_BT_true = fitByKabsch(model_T, discs_B);
  errors_mm_.push_back(1e3 * (X_BT.translation() - X_BT_true.translation()).norm());
}

double PoseAudit::rms_mm() const {
  if (errors_mm_.empty()) return 0.0;
  double sum = 0.0;
  for (const double error : errors_mm_) sum += error * error;
  return std::sqrt(sum / static_cast<double>(errors_mm_.size()));
}

double PoseAudit::p95_mm() const {
  if (errors_mm_.empty()) return 0.0;
  return quantile(errors_mm_, 0.95);
}

}  // namespace mirrorarm::cli
