#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/camera/stereo_rig.h"
#include "core/vision/disparity_support.h"
#include "core/vision/epipolar_geometry.h"
#include "core/vision/matcher_settings.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

/// Pairs left and right markers and triangulates them. Every pair that the centres' covariances and the
/// calibration's own error allow on one epipolar line, in the depth range, with outlines that one disc may
/// have, is handed on; where several claim a disc, the neighbours' disparity gradients say which is
/// preferred, and nothing is decided. Centres are corrected for eccentricity and lens curvature with the
/// normal that both outlines give. Keeps its buffers. One thread. Source: paper section 2.2.2; Pollard,
/// Mayhew, Frisby, Perception 14, 1985.
class StereoMatcher {
 public:
  StereoMatcher(const camera::StereoRig& rig, const MatcherSettings& settings);

  /// Preferred pairs first, the better supported before the others. The answer stays good until the next
  /// call; nothing is taken from the heap once the buffers have grown. At most kMostPairs pairs are looked
  /// at, those nearest to their epipolar lines: time is bounded whatever the images hold.
  [[nodiscard]] std::span<const StereoPoint> match(std::span<const DetectedMarker> left,
                                                   std::span<const DetectedMarker> right);
  static constexpr std::size_t kMostPairs = 1024;

 private:
  /// A marker in its rectified image.
  struct Sighting {
    RectifiedPoint at;
    double row_variance_px2 = 0.0;
    int marker = -1;
  };
  struct Candidate {
    int left = -1;  ///< index into lefts_
    int right = -1;
    double epipolar_misfit = 0.0;  ///< chi squared, 1 degree of freedom
  };
  enum class Side : std::uint8_t { kLeft, kRight };
  void sight(std::span<const DetectedMarker> markers, Side side, std::vector<Sighting>& sightings) const;
  void collect();
  void collectNear(std::size_t left, double reach_px);
  [[nodiscard]] bool isPossible(const Sighting& left, const Sighting& right, double epipolar_misfit) const;
  void keepTheNearest();
  void measure(const Candidate& candidate, std::span<const DetectedMarker> left,
               std::span<const DetectedMarker> right);

  camera::StereoRig rig_;
  MatcherSettings settings_;
  EpipolarGeometry geometry_;
  double calibration_variance_px2_;  ///< of one image's share in the distance from an epipolar line
  std::vector<Sighting> lefts_;
  std::vector<Sighting> rights_;  ///< by row
  std::vector<Candidate> candidates_;
  std::vector<RectifiedPair> pairs_;
  std::vector<StereoPoint> points_;
};

}  // namespace mirrorarm::vision
