#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace mirrorarm::benchmarks::vision {

/// ViSP's vpDot2. This header and its .cpp are C++17: the headers of ViSP 3.5 do not compile as C++20.
class VispDot {
 public:
  VispDot();
  ~VispDot();

  /// Centre of gravity (x, y) of the dot around (near_x, near_y), or nothing when ViSP finds none.
  [[nodiscard]] std::optional<std::array<double, 2>> centre(const std::uint8_t* pixels, int width, int height,
                                                            std::ptrdiff_t stride, double near_x,
                                                            double near_y);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::benchmarks::vision
