#include "core/calibration/candidate_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/camera/stereo_view.h"
#include "core/geometry/rigid_fit.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kTrials = 400;
constexpr double kLargestTilt_rad = 40.0 / 180.0 * std::numbers::pi;
constexpr double kLargestSpin_rad = 0.25 * std::numbers::pi;
constexpr double kNearest_m = 0.28;
constexpr double kFarthest_m = 0.60;
constexpr double kImageShare = 0.9;  ///< of the image's width and height that the board's middle may lie in
constexpr double kSeenShare = 0.8;
constexpr double kMargin_px = 8.0;

/// The `index`-th number of the van der Corput sequence in `base`: even over [0, 1) however many are taken.
/// Source: Halton, Numerische Mathematik 2, 1960.
double evenly(int index, int base) {
  double value = 0.0, share = 1.0;
  for (; index > 0; index /= base) {
    share /= base;
    value += share * (index % base);
  }
  return value;
}

double between(double low, double high, double share) { return low + share * (high - low); }

Eigen::Quaterniond tilted(double tilt_rad, double direction_rad, double spin_rad) {
  const Eigen::Vector3d axis(std::cos(direction_rad), std::sin(direction_rad), 0.0);
  return Eigen::Quaterniond(Eigen::AngleAxisd(tilt_rad, axis) *
                            Eigen::AngleAxisd(spin_rad, Eigen::Vector3d::UnitZ()));
}

class Maker {
 public:
  Maker(const camera::StereoRig& rig, std::span<const Eigen::Vector3d> board)
      : rig_(rig), board_(board), middle_M_(centroid(board)) {}

  /// Nothing where the lens model or both cameras do not see it.
  [[nodiscard]] std::optional<RigidTransform> make(int index) const {
    const auto& lens = rig_.left.intrinsics();
    const double edge = 0.5 * (1.0 - kImageShare);
    const auto ray = rig_.left.unproject({lens.width_px * between(edge, 1.0 - edge, evenly(index, 2)),
                                          lens.height_px * between(edge, 1.0 - edge, evenly(index, 3))});
    if (!ray) return std::nullopt;
    const Eigen::Vector3d middle_C =
        between(kNearest_m, kFarthest_m, evenly(index, 5)) * ray->homogeneous().normalized();
    const auto turn =
        tilted(kLargestTilt_rad * std::sqrt(evenly(index, 7)), 2.0 * std::numbers::pi * evenly(index, 11),
               between(-kLargestSpin_rad, kLargestSpin_rad, evenly(index, 13)));
    // Tilted against the line of sight, not against the image.
    const Eigen::Quaterniond facing =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), middle_C) * turn;
    const RigidTransform X_CM = makeTransform(facing, middle_C - facing * middle_M_);
    return isSeen(X_CM) ? std::optional(X_CM) : std::nullopt;
  }

 private:
  [[nodiscard]] bool isSeen(const RigidTransform& X_CM) const {
    const auto seen = std::ranges::count_if(board_, [&](const Eigen::Vector3d& p_M) {
      return camera::bothCamerasSee(rig_, X_CM * p_M, kMargin_px);
    });
    return static_cast<double>(seen) >= kSeenShare * static_cast<double>(board_.size());
  }

  const camera::StereoRig& rig_;
  std::span<const Eigen::Vector3d> board_;
  Eigen::Vector3d middle_M_;
};

}  // namespace

std::vector<RigidTransform> candidateViews(const camera::StereoRig& rig,
                                           std::span<const Eigen::Vector3d> board, int round) {
  const Maker maker(rig, board);
  std::vector<RigidTransform> candidates;
  for (int trial = 1; trial <= kTrials; ++trial)
    if (const auto X_CM = maker.make(round * kTrials + trial)) candidates.push_back(*X_CM);
  return candidates;
}

}  // namespace mirrorarm::calibration
