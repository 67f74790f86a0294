#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

inline constexpr int kMaxMarkers = 64;          ///< markers that one target may have
inline constexpr std::size_t kMaxPoints = 128;  ///< points considered for one target in one frame

/// How an answer was got.
enum class TrackStatus : std::uint8_t { kTracked, kPredicted, kLost };
/// "tracked", "predicted", "lost".
[[nodiscard]] std::string_view id(TrackStatus status);

/// Why a target was not tracked.
enum class LostReason : std::uint8_t {
  kNone,
  kNoPoints,       ///< the frame held no free point, near where the target is expected or at all
  kTooFewMarkers,  ///< too few points fit the model to prove that it is there
  kBadFit,         ///< enough, but they do not lie like the markers
  kNotConverged,   ///< the search was cut off by its time bound before anything fitted
  kAmbiguous,      ///< the points fit in several ways, or several targets fit them
  kOutOfVolume,    ///< it was about to leave, or has left, what both cameras see
  kStale,          ///< no frame has shown it for too long
};
/// "none", "no_points", "too_few_markers", "bad_fit", "not_converged", "ambiguous", "out_of_volume", "stale".
[[nodiscard]] std::string_view id(LostReason reason);

/// One target at one instant. A predicted one keeps the reason why it was not measured. Fixed size: it goes
/// through mailboxes without allocating.
struct TrackedTarget {
  TrackStatus status = TrackStatus::kLost;
  LostReason reason = LostReason::kNoPoints;
  RigidTransform X_CT = RigidTransform::Identity();  ///< target in the left camera; good unless lost
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Zero();  ///< turn [rad] then shift [m], in T
  TimePoint exposed_at{};                   ///< middle of the exposure
  double rms_m = 0.0;        ///< of the fit over the matched markers, to the shape the target has now
  double deviation_m = 0.0;  ///< of that shape from the one at rest, root mean square: how the skin moved
  int marker_count = 0;      ///< markers that the target has
  int matched_count = 0;     ///< markers that were found
  /// For each marker the index of its measured point, -1 when it was not found.
  std::array<std::int16_t, kMaxMarkers> point_of_marker{};
};

/// Largest standard deviation of the pose's shift over all directions [m].
[[nodiscard]] double shiftSigma(const TrackedTarget& target);
/// Largest standard deviation of its turn over all axes [rad].
[[nodiscard]] double turnSigma(const TrackedTarget& target);

/// True while the pose may still move a robot or a drawing: tracked or predicted, not older than `max_age`,
/// not from the future. The one gate to the robot and to green on the screen.
[[nodiscard]] inline bool isFresh(const TrackedTarget& target, TimePoint now, Seconds max_age) {
  const Seconds age = now - target.exposed_at;
  return target.status != TrackStatus::kLost && age >= Seconds::zero() && age <= max_age;
}

}  // namespace mirrorarm::tracking
