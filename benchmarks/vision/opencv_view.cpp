#include "benchmarks/vision/opencv_view.h"

#include <opencv2/core/mat.hpp>

namespace mirrorarm::benchmarks::vision {

cv::Mat viewOf(const camera::ImageView& image) {
  return {image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.data),
          static_cast<std::size_t>(image.stride)};
}

}  // namespace mirrorarm::benchmarks::vision
