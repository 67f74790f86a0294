#pragma once

#include "core/camera/image.h"

namespace cv {
class Mat;
}

namespace mirrorarm::benchmarks::vision {

/// The image as OpenCV's, sharing its pixels, which nobody may write to.
[[nodiscard]] cv::Mat viewOf(const camera::ImageView& image);

}  // namespace mirrorarm::benchmarks::vision
