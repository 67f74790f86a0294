#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

namespace mirrorarm::benchmarks::vision {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;
inline constexpr Colour kInk{40, 40, 40};
inline constexpr Colour kFaint{215, 215, 215};

/// The `index`-th of nine colours that stay apart, also for people who do not tell red from green.
[[nodiscard]] Colour colourOf(std::size_t index);

/// Which part of a text its place means.
enum class Align { kLeft, kMiddle, kRight };

/// A white picture to draw on; places in pixels, x to the right, y down.
class Canvas {
 public:
  using Place = Eigen::Vector2d;

  Canvas(int width_px, int height_px);
  ~Canvas();

  void line(const Place& from, const Place& to, const Colour& colour, int thickness_px = 1);
  void arrow(const Place& from, const Place& to, const Colour& colour);
  void dot(const Place& at, double radius_px, const Colour& colour);
  void box(const Place& low, const Place& high, const Colour& colour, bool filled = false);
  /// One line, `at` on its base line.
  void text(const std::string& words, const Place& at, Align align = Align::kLeft, double scale = 0.5);
  /// As PNG. Throws std::runtime_error when it cannot be written.
  void save(const std::filesystem::path& file) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::benchmarks::vision
