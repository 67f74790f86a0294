#include "benchmarks/vision/visp_dot.h"

#include <algorithm>

#include <visp3/blob/vpDot2.h>

namespace mirrorarm::benchmarks::vision {

struct VispDot::Body {
  vpImage<unsigned char> image;
};

VispDot::VispDot() : body_(std::make_unique<Body>()) {}
VispDot::~VispDot() = default;

std::optional<std::array<double, 2>> VispDot::centre(const std::uint8_t* pixels, int width, int height,
                                                     std::ptrdiff_t stride, double near_x, double near_y) {
  auto& image = body_->image;
  image.resize(static_cast<unsigned>(height), static_cast<unsigned>(width));
  for (int y = 0; y < height; ++y) std::copy_n(pixels + y * stride, width, image[static_cast<unsigned>(y)]);
  vpDot2 dot;
  dot.setGraphics(false);
  dot.setEllipsoidShapePrecision(0.0);
  try {
    dot.initTracking(image, vpImagePoint(near_y, near_x));
  } catch (const vpException&) {
    return std::nullopt;
  }
  const vpImagePoint centre = dot.getCog();
  return std::array<double, 2>{centre.get_u(), centre.get_v()};
}

}  // namespace mirrorarm::benchmarks::vision
