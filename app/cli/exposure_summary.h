#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/vision/detected_marker.h"

namespace mirrorarm::cli {

/// How one camera's images were lit, over all of them.
class ExposureSummary {
 public:
  explicit ExposureSummary(std::string camera) : camera_(std::move(camera)) {}

  void add(const vision::Exposure& exposure);
  [[nodiscard]] const std::string& camera() const { return camera_; }

  /// camera, images, background and noise (medians), brightest (largest), saturated_markers (all), warning
  /// (the worst; null for none), warned_images.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  std::string camera_;
  std::vector<double> backgrounds_;
  std::vector<double> noises_;
  double brightest_ = 0.0;
  int saturated_markers_ = 0;
  int warned_images_ = 0;
  std::optional<vision::ExposureWarning> worst_;
};

}  // namespace mirrorarm::cli
