#include "fuzz_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include <climits>

#include "core/camera/image_file.h"

namespace mirrorarm::vision {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Canvas {
  int width;
  int height;
  std::vector<std::uint8_t> pixels;

  Canvas(int w, int h, int level)
      : width(w),
        height(h),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), static_cast<std::uint8_t>(level)) {}
  std::uint8_t& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  template <class Level>
  void fill(Level level) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        at(x, y) = static_cast<std::uint8_t>(std::clamp(static_cast<double>(level(x, y)), 0.0, 255.0));
  }
};

/// Photographs of the shared data; none where it is absent.
const std::vector<camera::GreyImage>& photographs() {
  static const auto loaded = [] {
    std::vector<camera::GreyImage> images;
    for (const char* name :
         {"ucl-dots-metal/14_10_22/left_image.png", "ucl-dots-metal/14_12_44/right_image.png",
          "opencv-chess-stereo/left01.jpg", "opencv-chess-stereo/right05.jpg"})
      if (auto image = camera::readImage(std::filesystem::path(SHARED_DATA) / name))
        images.push_back(std::move(*image));
    return images;
  }();
  return loaded;
}

/// `likely`: such as markers are.
void addDiscs(FuzzSource& source, Canvas& canvas, bool likely) {
  for (int i = source.whole(1, 12); i > 0; --i) {
    const double cx = source.real(-5, canvas.width + 5), cy = source.real(-5, canvas.height + 5);
    const double a = likely ? source.real(3.0, 9.0) : source.real(0.3, 30.0);
    const double b = a * source.real(likely ? 0.5 : 0.1, 1.0), turn = source.real(0.0, 3.2);
    const int level = likely ? source.whole(120, 255) : source.whole(0, 255);
    const double soft = likely ? 1.5 : source.real(0.1, 3.0);
    canvas.fill([&](int x, int y) -> double {
      const double u = std::cos(turn) * (x - cx) + std::sin(turn) * (y - cy);
      const double v = -std::sin(turn) * (x - cx) + std::cos(turn) * (y - cy);
      const double inside = std::clamp((1.0 - std::hypot(u / a, v / b)) * b / soft + 0.5, 0.0, 1.0);
      return canvas.at(x, y) + inside * (level - canvas.at(x, y));
    });
  }
}

void addBars(FuzzSource& source, Canvas& canvas) {
  for (int i = source.whole(1, 10); i > 0; --i) {
    const int left = source.whole(0, canvas.width - 1), top = source.whole(0, canvas.height - 1);
    const int right = std::min(left + source.whole(0, 60), canvas.width - 1);
    const int bottom = std::min(top + source.whole(0, 60), canvas.height - 1);
    const int level = source.whole(0, 255);
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) canvas.at(x, y) = static_cast<std::uint8_t>(level);
  }
}

void addCutting(FuzzSource& source, Canvas& canvas) {
  if (photographs().empty()) return addDiscs(source, canvas, false);
  const auto& photograph =
      photographs()[static_cast<std::size_t>(source.whole(0, static_cast<int>(photographs().size()) - 1))];
  const int left = source.whole(0, photograph.width() - 1), top = source.whole(0, photograph.height() - 1);
  const auto view = photograph.view();
  canvas.fill([&](int x, int y) {
    return view.at(std::min(left + x, view.width_px - 1), std::min(top + y, view.height_px - 1));
  });
  for (int i = source.whole(0, 50); i > 0; --i)
    canvas.at(source.whole(0, canvas.width - 1), source.whole(0, canvas.height - 1)) =
        static_cast<std::uint8_t>(source.whole(0, 255));
}

void addContent(FuzzSource& source, Canvas& canvas) {
  const double a = source.real(-4, 4), b = source.real(-4, 4);
  const int side = source.whole(1, 20), column = source.whole(0, canvas.width - 1);
  switch (source.whole(0, 12)) {
    case 0:
      return canvas.fill([&](int, int) { return source.whole(0, 255); });
    case 1:
      return canvas.fill(
          [&](int x, int y) { return source.oneIn(20) ? 255 * source.whole(0, 1) : int{canvas.at(x, y)}; });
    case 2:
      return canvas.fill([&](int x, int y) { return 100 + a * x + b * y; });
    case 3:
      return canvas.fill([&](int x, int y) { return (x / side + y / side) % 2 * 255; });
    case 4:
      return addBars(source, canvas);
    case 5:
      return canvas.fill([&](int x, int y) { return x == column ? 255 : int{canvas.at(x, y)}; });
    case 6:
    case 7:
      return addCutting(source, canvas);
    case 8:
      return;  // one grey all over
    default:
      return addDiscs(source, canvas, source.oneIn(2));
  }
}

void addNoise(FuzzSource& source, Canvas& canvas) {
  const double sigma = source.real(0.0, 12.0);
  canvas.fill([&](int x, int y) {
    const double sum = source.real(-1, 1) + source.real(-1, 1) + source.real(-1, 1);
    return canvas.at(x, y) + sigma * sum;
  });
}

int side(FuzzSource& source) {
  if (source.oneIn(6)) return source.whole(1, 9);
  return source.oneIn(12) ? source.whole(150, 420) : source.whole(10, 150);
}

}  // namespace

camera::GreyImage FuzzSource::picture(int width, int height) {
  if (width == 0) width = side(*this);
  if (height == 0) height = side(*this);
  constexpr std::array levels{0, 255, 254, 10, 128};
  if (oneIn(3)) return markers(width, height);
  Canvas canvas(width, height, levels[static_cast<std::size_t>(whole(0, 4))]);
  for (int layer = whole(1, 2); layer > 0; --layer) addContent(*this, canvas);
  if (oneIn(2)) addNoise(*this, canvas);
  return {width, height, std::move(canvas.pixels)};
}

camera::GreyImage FuzzSource::markers(int width, int height) {
  Canvas canvas(width, height, 12);
  addDiscs(*this, canvas, true);
  if (oneIn(2)) addNoise(*this, canvas);
  return {width, height, std::move(canvas.pixels)};
}

camera::GreyImage FuzzSource::partnerOf(const camera::GreyImage& image) {
  const int disparity = whole(0, image.width());
  Canvas canvas(image.width(), image.height(), 0);
  const auto view = image.view();
  canvas.fill([&](int x, int y) { return view.at(std::min(x + disparity, view.width_px - 1), y); });
  if (oneIn(2)) addContent(*this, canvas);
  return {canvas.width, canvas.height, std::move(canvas.pixels)};
}

double FuzzSource::absurdOr(double sensible) {
  constexpr std::array<double, 11> absurd{0.0,    -1.0, -1e9,      1e9,        1e300, -1e300,
                                          1e-300, kNan, kInfinity, -kInfinity, 1e-9};
  return oneIn(8) ? absurd[static_cast<std::size_t>(whole(0, absurd.size() - 1))] : sensible;
}

FinderSettings FuzzSource::settings() {
  FinderSettings settings = oneIn(4) ? plateSettings() : FinderSettings{};
  settings.method = static_cast<CentreMethod>(whole(0, 2));
  settings.dark_on_bright = oneIn(2);
  if (oneIn(2)) return settings;
  for (double* value :
       {&settings.min_diameter_px, &settings.max_diameter_px, &settings.max_axis_ratio,
        &settings.max_fit_rms_px, &settings.outline_tolerance_px, &settings.outline_tolerance_of_radius,
        &settings.light_tolerance, &settings.max_centre_sigma_px, &settings.min_outline_fraction,
        &settings.edge_sigma_px, &settings.min_size_of_neighbours, &settings.blur_px,
        &settings.blur_tolerance_px})
    *value = absurdOr(*value * real(0.5, 2.0));
  return settings;
}

camera::CameraModel FuzzSource::camera(int width, int height) {
  const bool fisheye = oneIn(2);
  camera::Intrinsics i;
  i.model = fisheye ? camera::LensModel::kKannalaBrandt : camera::LensModel::kBrownConrady;
  i.width_px = width;
  i.height_px = height;
  i.fx_px = real(0.3, 2.0) * width;
  i.fy_px = real(0.3, 2.0) * width;
  i.cx_px = 0.5 * width + real(-5, 5);
  i.cy_px = 0.5 * height + real(-5, 5);
  const double strength = oneIn(3) ? 3.0 : 0.1;
  for (std::size_t k = 0; k < (fisheye ? 4U : 5U); ++k) i.distortion[k] = real(-strength, strength);
  if (oneIn(5))
    for (double* value : {&i.fx_px, &i.fy_px, &i.cx_px, &i.cy_px, &i.distortion[0], &i.distortion[3]})
      *value = absurdOr(*value);
  return camera::CameraModel(i);
}

camera::StereoRig FuzzSource::rig(int width, int height) {
  camera::StereoRig rig;
  if (oneIn(2)) {
    const double f_px = 1.2 * width;
    rig.left = rig.right = camera::CameraModel(
        {camera::LensModel::kBrownConrady, width, height, f_px, f_px, 0.5 * width, 0.5 * height, {-0.05}});
    rig.X_RC = makeTransform(Eigen::Quaterniond::Identity(), {-0.12, 0.0, 0.0});
    return rig;
  }
  rig.left = camera(width, height);
  rig.right = oneIn(4) ? camera(width, height) : rig.left;
  const Eigen::Vector3d axis(real(-1, 1), real(-1, 1), real(-1, 1));
  const double turn = oneIn(4) ? real(-3.1, 3.1) : real(-0.1, 0.1);
  rig.X_RC = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(turn, axis.stableNormalized())),
                           {absurdOr(-0.12), absurdOr(real(-0.01, 0.01)), absurdOr(real(-0.01, 0.01))});
  return rig;
}

std::vector<Region> FuzzSource::regions(int width, int height) {
  std::vector<Region> regions;
  constexpr std::array ends{INT_MIN, INT_MIN + 1, INT_MAX - 1, INT_MAX, -1, 0};
  const auto end = [&](int size) {
    return oneIn(4) ? ends[static_cast<std::size_t>(whole(0, ends.size() - 1))] : whole(-20, size + 20);
  };
  for (int i = oneIn(2) ? 0 : whole(1, 12); i > 0; --i)
    regions.push_back({end(width), end(height), end(width), end(height)});
  return regions;
}

std::vector<Eigen::Vector3d> FuzzSource::points() {
  std::vector<Eigen::Vector3d> points;
  for (int i = oneIn(2) ? 0 : whole(1, 12); i > 0; --i)
    points.emplace_back(absurdOr(real(-0.3, 0.3)), absurdOr(real(-0.3, 0.3)), absurdOr(real(-0.2, 1.0)));
  return points;
}

SpacedPicture::SpacedPicture(const camera::GreyImage& image, int gap_px)
    : width_(image.width()),
      height_(image.height()),
      stride_(image.width() + gap_px),
      bytes_(static_cast<std::size_t>((height_ - 1) * stride_ + width_), 0xa5) {
  for (int y = 0; y < height_; ++y)
    std::memcpy(bytes_.data() + y * stride_, image.view().row(y), static_cast<std::size_t>(width_));
}

}  // namespace mirrorarm::vision
