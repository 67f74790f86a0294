#include "core/calibration/seen_discs.h"

#include <cmath>

#include "core/vision/marker_finder.h"

namespace mirrorarm::calibration {

std::vector<SeenPoint> seenDiscs(const camera::ImageView& image, const vision::FinderSettings& settings) {
  std::vector<SeenPoint> discs;
  vision::MarkerFinder finder(settings);
  for (const auto& marker : finder.find(image).markers) {
    if (marker.cut) continue;
    SeenPoint disc;
    disc.pixel = marker.ellipse.centre_px;
    disc.sigma_px = std::sqrt(0.5 * marker.covariance_px2.trace());
    disc.shape_px2 = vision::shapeOf(marker.ellipse);
    discs.push_back(disc);
  }
  return discs;
}

}  // namespace mirrorarm::calibration
