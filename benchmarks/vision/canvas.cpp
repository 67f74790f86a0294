#include "benchmarks/vision/canvas.h"

#include <stdexcept>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr int kFraction = 4;  // bits of OpenCV's fixed-point places

cv::Point finely(const Canvas::Place& place) {
  const Eigen::Vector2d fixed = place * (1 << kFraction);
  return {cvRound(fixed.x()), cvRound(fixed.y())};
}

cv::Point roughly(const Canvas::Place& place) { return {cvRound(place.x()), cvRound(place.y())}; }

cv::Scalar scalarOf(const Colour& colour) { return {1.0 * colour[2], 1.0 * colour[1], 1.0 * colour[0]}; }

}  // namespace

// Source: Okabe and Ito, "Color Universal Design", 2008; grey for yellow's bad contrast on white.
Colour colourOf(std::size_t index) {
  constexpr std::array<Colour, 9> kColours{{{0, 114, 178},
                                            {213, 94, 0},
                                            {0, 158, 115},
                                            {204, 121, 167},
                                            {230, 159, 0},
                                            {86, 180, 233},
                                            {150, 150, 150},
                                            {120, 80, 40},
                                            {0, 0, 0}}};
  return kColours[index % kColours.size()];
}

struct Canvas::Body {
  cv::Mat picture;
};

Canvas::Canvas(int width_px, int height_px)
    : body_(std::make_unique<Body>(cv::Mat(height_px, width_px, CV_8UC3, cv::Scalar::all(255)))) {}
Canvas::~Canvas() = default;

void Canvas::line(const Place& from, const Place& to, const Colour& colour, int thickness_px) {
  cv::line(body_->picture, finely(from), finely(to), scalarOf(colour), thickness_px, cv::LINE_AA, kFraction);
}

void Canvas::arrow(const Place& from, const Place& to, const Colour& colour) {
  constexpr double kTip_px = 4.0;
  const double length_px = (to - from).norm();
  if (length_px < 1.0) return;
  cv::arrowedLine(body_->picture, finely(from), finely(to), scalarOf(colour), 1, cv::LINE_AA, kFraction,
                  std::min(0.5, kTip_px / length_px));
}

void Canvas::dot(const Place& at, double radius_px, const Colour& colour) {
  cv::circle(body_->picture, finely(at), cvRound(radius_px * (1 << kFraction)), scalarOf(colour), cv::FILLED,
             cv::LINE_AA, kFraction);
}

void Canvas::box(const Place& low, const Place& high, const Colour& colour, bool filled) {
  cv::rectangle(body_->picture, roughly(low), roughly(high), scalarOf(colour), filled ? cv::FILLED : 1);
}

void Canvas::text(const std::string& words, const Place& at, Align align, double scale) {
  constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  const int width = cv::getTextSize(words, kFont, scale, 1, nullptr).width;
  cv::Point place = roughly(at);
  if (align == Align::kMiddle) place.x -= width / 2;
  if (align == Align::kRight) place.x -= width;
  cv::putText(body_->picture, words, place, kFont, scale, scalarOf(kInk), 1, cv::LINE_AA);
}

void Canvas::save(const std::filesystem::path& file) const {
  if (!cv::imwrite(file.string(), body_->picture, {cv::IMWRITE_PNG_COMPRESSION, 9}))
    throw std::runtime_error("cannot write " + file.string());
}

}  // namespace mirrorarm::benchmarks::vision
