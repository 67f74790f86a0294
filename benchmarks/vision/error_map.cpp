#include "benchmarks/vision/error_map.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "benchmarks/report.h"
#include "benchmarks/statistics.h"
#include "benchmarks/vision/canvas.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kScale = 0.62;  // of the image in the picture
constexpr double kLeft = 20.0, kTop = 50.0, kBelow = 60.0;
constexpr double kLongArrow_px = 30.0;
constexpr std::size_t kMostArrows = 300;  // more could not be told apart
constexpr double kLeastColour_px = 0.0001, kMostColour_px = 1.0;

/// From violet at 0.0001 px over blue, green and orange to red at 1 px, logarithmic.
Colour colourOfError(double error_px) {
  constexpr std::array<Colour, 5> kStops{
      {{110, 40, 160}, {30, 60, 200}, {0, 150, 110}, {240, 150, 0}, {190, 0, 30}}};
  const double decades = std::log10(std::clamp(error_px, kLeastColour_px, kMostColour_px) / kLeastColour_px);
  const auto below = std::min(static_cast<std::size_t>(decades), kStops.size() - 2);
  const double share = decades - static_cast<double>(below);
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(
        std::lround((1.0 - share) * kStops[below][i] + share * kStops[below + 1][i]));
  return colour;
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double roundBelow(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / decade;
  return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

void drawColours(Canvas& canvas, double right, double y) {
  constexpr int kSteps = 160, kDecades = 4;
  for (int i = 0; i < kSteps; ++i) {
    const double error_px = kLeastColour_px * std::pow(kMostColour_px / kLeastColour_px, (i + 0.5) / kSteps);
    const double x = right - 2.0 * (kSteps - i);
    canvas.box({x, y - 14.0}, {x + 2.0, y - 4.0}, colourOfError(error_px), true);
  }
  for (int decade = 0; decade <= kDecades; ++decade)
    canvas.text(shortNumber(kLeastColour_px * std::pow(10.0, decade)) + (decade == kDecades ? " px" : ""),
                {right - 2.0 * kSteps * (1.0 - static_cast<double>(decade) / kDecades), y + 12.0},
                Align::kMiddle, 0.4);
}

}  // namespace

void ErrorMap::write(const std::filesystem::path& file) const {
  const Eigen::Vector2d low(kLeft, kTop), high = low + kScale * Eigen::Vector2d(width_px_, height_px_);
  Canvas canvas(static_cast<int>(high.x() + kLeft), static_cast<int>(high.y() + kBelow));
  std::vector<double> lengths;
  RootMeanSquare rms;
  for (const Error& error : errors_) {
    lengths.push_back(error.error_px.norm());
    rms.addSquare(error.error_px.squaredNorm(), 2);
  }
  canvas.text(title_ + ": " + shortNumber(rms.value()) + " px rms per axis, " +
                  std::to_string(errors_.size()) + " discs",
              {kLeft, kTop - 18.0});
  canvas.box(low, high, kInk);
  const double long_error_px = std::max(quantile(lengths, 0.9), 1e-6);
  const double magnification = errors_.empty() ? 1.0 : kLongArrow_px / long_error_px;
  for (const Error& error : errors_ | std::views::take(kMostArrows)) {
    const Eigen::Vector2d at = low + kScale * error.at_px;
    const Colour colour = colourOfError(error.error_px.norm());
    canvas.dot(at, 2.0, colour);
    canvas.arrow(at, at + magnification * error.error_px, colour);
  }
  const double bar_px = roundBelow(2.0 * long_error_px);
  const double y = high.y() + 30.0;
  canvas.line({kLeft, y - 4.0}, {kLeft + magnification * bar_px, y - 4.0}, kInk, 2);
  canvas.text(shortNumber(bar_px) + " px", {kLeft + magnification * bar_px + 10.0, y});
  drawColours(canvas, high.x() - 20.0, y);
  canvas.save(file);
}

}  // namespace mirrorarm::benchmarks::vision
