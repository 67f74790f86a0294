#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/tracking/target.h"
#include "core/tracking/tracker.h"

namespace mirrorarm::tracking {

/// Teaches a target anew from one cloud, in the frame it already has, when its markers have moved against
/// each other so far that the rigid fit is rejected: the cloud is registered with a wide tolerance from the
/// last known pose, and every marker that finds its point takes the point's place. Markers without a point
/// keep theirs. Nothing when fewer than `settings.min_marker_share` of the markers (and three) find one, or
/// when what they find lies further from the old model than skin moves (20 mm rms): then only a new lesson
/// helps. Source: paper section 3.1, "repeated online".
[[nodiscard]] std::optional<Target> reteach(const Target& old, std::span<const Eigen::Vector3d> cloud_C,
                                            const RigidTransform& X_CT_last, const TrackerSettings& settings);

}  // namespace mirrorarm::tracking
