#pragma once

#include <vector>

#include "core/calibration/sighting.h"
#include "core/camera/image.h"
#include "core/vision/finder_settings.h"

namespace mirrorarm::calibration {

/// The discs of an image in any order, `point` left at 0: outlines by maximum likelihood, with what the noise
/// makes of their centres. Discs that something covers in part are left out.
[[nodiscard]] std::vector<SeenPoint> seenDiscs(const camera::ImageView& image,
                                               const vision::FinderSettings& settings);

}  // namespace mirrorarm::calibration
