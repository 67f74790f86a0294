#include "benchmarks/vision/error_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "benchmarks/report.h"
#include "benchmarks/vision/canvas.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr int kWidth = 900, kHeight = 560;
constexpr int kLeft = 90, kTop = 50, kRight = 640, kBottom = 480;

/// Logarithmic axis between two ends, a little wider than what it shows.
struct Axis {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double share(double value) const {
    const double margin = 0.05 * std::log(high / low) + 1e-9;
    return (std::log(value / low) + margin) / (std::log(high / low) + 2.0 * margin);
  }
};

/// 1, 2 and 5 times the powers of ten within the axis.
std::vector<double> ticksOf(const Axis& axis) {
  std::vector<double> ticks;
  for (double decade = std::pow(10.0, std::floor(std::log10(axis.low))); decade <= axis.high; decade *= 10.0)
    for (const double step : {1.0, 2.0, 5.0}) {
      const double share = axis.share(step * decade);
      if (share >= 0.0 && share <= 1.0) ticks.push_back(step * decade);
    }
  return ticks;
}

struct Frame {
  Axis x, y;

  [[nodiscard]] double column(double value) const { return kLeft + x.share(value) * (kRight - kLeft); }
  [[nodiscard]] double row(double value) const { return kBottom - y.share(value) * (kBottom - kTop); }
};

void drawGrid(Canvas& canvas, const Frame& frame) {
  for (const double tick : ticksOf(frame.y)) {
    const double row = frame.row(tick);
    canvas.line({kLeft, row}, {kRight, row}, kFaint);
    canvas.text(shortNumber(tick), {kLeft - 8, row + 5}, Align::kRight, 0.45);
  }
  for (const double tick : ticksOf(frame.x)) {
    const double column = frame.column(tick);
    canvas.line({column, kTop}, {column, kBottom}, kFaint);
    canvas.text(shortNumber(tick), {column, kBottom + 20}, Align::kMiddle, 0.45);
  }
  canvas.box({kLeft, kTop}, {kRight, kBottom}, kInk);
}

void drawCurve(Canvas& canvas, const Frame& frame, const std::vector<Chart::Point>& points,
               const Colour& colour) {
  constexpr double kDot_px = 4.0;
  const auto placeOf = [&](const Chart::Point& point) {
    return Canvas::Place(frame.column(point.x), frame.row(point.y));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    canvas.dot(placeOf(points[i]), kDot_px, colour);
    if (i > 0) canvas.line(placeOf(points[i - 1]), placeOf(points[i]), colour, 2);
  }
}

}  // namespace

void Chart::add(const std::string& curve, const Point& point) {
  if (!(point.x > 0.0) || !(point.y > 0.0) || !std::isfinite(point.y)) return;
  auto found = std::ranges::find(curves_, curve, &Curve::name);
  if (found == curves_.end()) found = curves_.insert(found, {curve, {}});
  found->points.push_back(point);
}

void Chart::write(const std::filesystem::path& file) const {
  Canvas canvas(kWidth, kHeight);
  Frame frame;
  for (const Curve& curve : curves_)
    for (const Point& point : curve.points) {
      frame.x.take(point.x);
      frame.y.take(point.y);
    }
  canvas.text(title_ + ", " + y_title_, {kLeft, kTop - 18}, Align::kLeft, 0.6);
  canvas.text(x_title_, {0.5 * (kLeft + kRight), kBottom + 50}, Align::kMiddle);
  if (!curves_.empty()) drawGrid(canvas, frame);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    drawCurve(canvas, frame, curves_[i].points, colourOf(i));
    const double row = kTop + 20.0 + 26.0 * static_cast<double>(i);
    canvas.line({kRight + 20, row - 5}, {kRight + 50, row - 5}, colourOf(i), 3);
    canvas.text(curves_[i].name, {kRight + 58, row}, Align::kLeft, 0.45);
  }
  canvas.save(file);
}

}  // namespace mirrorarm::benchmarks::vision
