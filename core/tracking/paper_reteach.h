#pragma once

#include <optional>
#include <span>

#include "core/tracking/cloud_point.h"
#include "core/tracking/paper_registration.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

/// Teaches a target anew from one cloud, in the frame it already has, when its markers have moved against
/// each other so far that the rigid fit is rejected: the cloud is registered with a wide tolerance from the
/// last known pose, and every marker that finds its point takes the point's place. Markers without a point
/// keep theirs. Nothing when fewer than `settings.min_marker_share` of the markers (and three) find one, or
/// when what they find lies further from the old model than skin moves (20 mm rms).
/// Source: paper section 3.1, "repeated online".
[[nodiscard]] std::optional<Target> paperReteach(const Target& old, std::span<const CloudPoint> cloud,
                                                 const RigidTransform& X_CT_last,
                                                 const PaperSettings& settings);

}  // namespace mirrorarm::tracking
