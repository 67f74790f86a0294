#pragma once

#include <memory>

#include "core/camera/stereo_frame.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::benchmarks::vision {

/// What a program written on OpenCV does to both images: cv::remap into the rectified images of the rig (maps
/// made once, at its own focal length), cv::GaussianBlur, cv::Canny, cv::findContours and
/// cv::fitEllipseDirect of every contour, with OpenCV's own threads.
class ReferenceChain {
 public:
  explicit ReferenceChain(const camera::StereoRig& rig);
  ~ReferenceChain();

  /// How many ellipses both images hold.
  int run(const camera::StereoFrame& frame);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::benchmarks::vision
