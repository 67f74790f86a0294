#pragma once

#include <memory>
#include <span>

#include "core/camera/stereo_frame.h"
#include "core/camera/stereo_rig.h"
#include "core/vision/marker_finder.h"
#include "core/vision/stereo_matcher.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

/// From two raw images to 3D points: markers left and right in parallel, matched and triangulated.
/// One thread calls it (the tracking thread); it owns a second one for the right image.
class StereoVision {
 public:
  StereoVision(const camera::StereoRig& rig, const FinderSettings& finder, const MatcherSettings& matcher);
  ~StereoVision();
  StereoVision(const StereoVision&) = delete;
  StereoVision& operator=(const StereoVision&) = delete;

  /// Images of another size than the rig's, and a rig with numbers that are none, give an observation without
  /// markers. The answer stays good until the next call; nothing is taken from the heap once the buffers have
  /// grown.
  [[nodiscard]] const StereoObservation& observe(const camera::StereoFrame& frame);

  /// The discs that are expected next, to look only around them; empty for the whole image.
  void expect(std::span<const Eigen::Vector3d> points_C, double radius_m);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::vision
