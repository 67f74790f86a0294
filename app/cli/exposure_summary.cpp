#include "app/cli/exposure_summary.h"

#include <algorithm>

#include "core/common/quantile.h"

namespace mirrorarm::cli {

void ExposureSummary::add(const vision::Exposure& exposure) {
  backgrounds_.push_back(exposure.background);
  noises_.push_back(exposure.noise);
  brightest_ = std::max(brightest_, exposure.brightest);
  saturated_markers_ += exposure.saturated_markers;
  if (!exposure.warning) return;
  ++warned_images_;
  worst_ = worst_ ? std::min(*worst_, *exposure.warning) : *exposure.warning;
}

nlohmann::ordered_json ExposureSummary::json() const {
  nlohmann::ordered_json object{{"camera", camera_},
                                {"images", backgrounds_.size()},
                                {"background", quantile(backgrounds_, 0.5)},
                                {"noise", quantile(noises_, 0.5)},
                                {"brightest", brightest_},
                                {"saturated_markers", saturated_markers_},
                                {"warning", nullptr},
                                {"warned_images", warned_images_}};
  if (worst_) object["warning"] = std::string(id(*worst_));
  return object;
}

}  // namespace mirrorarm::cli
