#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace mirrorarm::camera {

/// A look at an 8-bit grey image that somebody else keeps alive. Pixel (x, y): x to the right, y down,
/// centres at integers.
struct ImageView {
  const std::uint8_t* data = nullptr;
  int width_px = 0;
  int height_px = 0;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next

  [[nodiscard]] const std::uint8_t* row(int y) const { return data + y * stride; }
  [[nodiscard]] std::uint8_t at(int x, int y) const { return row(y)[x]; }
  [[nodiscard]] bool empty() const { return data == nullptr || width_px <= 0 || height_px <= 0; }
};

/// An 8-bit grey image. Copies share the pixels, which nobody changes once they are shared: so a frame can go
/// to several threads without being copied.
class GreyImage {
 public:
  GreyImage() = default;
  /// Takes `pixels` row by row without gaps; `pixels.size()` is width times height.
  GreyImage(int width_px, int height_px, std::vector<std::uint8_t> pixels)
      : width_px_(width_px),
        height_px_(height_px),
        pixels_(std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))) {}

  [[nodiscard]] int width() const { return width_px_; }
  [[nodiscard]] int height() const { return height_px_; }
  [[nodiscard]] bool empty() const { return pixels_ == nullptr || pixels_->empty(); }
  [[nodiscard]] ImageView view() const {
    return {pixels_ ? pixels_->data() : nullptr, width_px_, height_px_, width_px_};
  }

 private:
  int width_px_ = 0;
  int height_px_ = 0;
  std::shared_ptr<const std::vector<std::uint8_t>> pixels_;
};

}  // namespace mirrorarm::camera
