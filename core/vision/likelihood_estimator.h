#pragma once

#include <array>

#include "core/vision/disc_estimator.h"
#include "core/vision/likelihood_fit.h"
#include "core/vision/outline_profile.h"

namespace mirrorarm::vision {

/// The default measurement: the maximum-likelihood fit of a blurred disc to the raw pixels around the light.
/// A light whose outline does not follow the fitted disc is no disc, or one that something covers in part:
/// measureCut() then fits a disc and a straight cover together, from eight directions.
class LikelihoodEstimator final : public DiscEstimator {
 public:
  explicit LikelihoodEstimator(const FinderSettings& settings)
      : settings_(settings), fit_(settings.blur_px, settings.blur_tolerance_px) {}

  [[nodiscard]] Expected<DetectedMarker, Rejection> measure(const Brightness& image,
                                                            const Light& light) override;
  [[nodiscard]] Expected<DetectedMarker, Rejection> measureCut(const Brightness& image,
                                                               const Light& light) override;

 private:
  [[nodiscard]] std::optional<FittedDisc> fitCovered(const Brightness& image, const Region& window,
                                                     const Light& light);
  [[nodiscard]] bool follows(const FittedDisc& fitted, const Light& light, const Brightness& image,
                             const Region& window);
  [[nodiscard]] bool isSpeck(const BlurredDisc& disc, const Light& light) const;
  [[nodiscard]] BlurredDisc startOf(const Light& light) const;
  [[nodiscard]] DetectedMarker markerOf(const FittedDisc& fitted) const;

  FinderSettings settings_;
  LikelihoodFit fit_;
  OutlineProfile profile_;
};

}  // namespace mirrorarm::vision
