#include "benchmarks/vision/spurious_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "benchmarks/suite.h"
#include "benchmarks/trial_random.h"
#include "benchmarks/vision/light.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kSpread_px = 0.7;
constexpr double kGround = 12.0;
constexpr double kGap_px = 6.0, kBorder_px = 4.0;
constexpr double kLeastContrast = 40.0, kMostContrast = 200.0;
constexpr double kLeastSnr = 20.0, kMostSnr = 100.0;
constexpr std::uint64_t kStockStream = 51, kFrameStream = 52, kNoiseStream = 54;

Outline turnedPolygon(const PlacedLight& light, const std::vector<Eigen::Vector2d>& corners,
                      double angle_rad) {
  const Eigen::Rotation2Dd turn(angle_rad);
  std::vector<Eigen::Vector2d> turned;
  for (const auto& corner : corners) turned.push_back(light.centre_px + turn * corner);
  return polygonOutline(turned);
}

Outline outlineOf(const PlacedLight& light, double angle_rad) {
  const double a = 0.5 * light.size_px, b = a * light.slimness;
  const double inner = 2.0 * b - a;  // where the arms of an L-shape meet; its arms are 2 b wide
  switch (light.shape) {
    case Shape::kStrip:
    case Shape::kRectangle:
    case Shape::kSpeck:
      return turnedPolygon(light, {{-a, -b}, {a, -b}, {a, b}, {-a, b}}, angle_rad);
    case Shape::kAngle:
      return turnedPolygon(light, {{-a, -a}, {a, -a}, {a, inner}, {inner, inner}, {inner, a}, {-a, a}},
                           angle_rad);
    default:
      break;
  }
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
  return ellipseOutline(light.centre_px, turn * Eigen::Vector2d(a, b).asDiagonal());
}

/// Size and slimness of a shape.
PlacedLight randomLight(Shape shape, TrialRandom& random) {
  PlacedLight light;
  light.shape = shape;
  const auto set = [&](double size_px, double slimness) {
    light.size_px = size_px;
    light.slimness = slimness;
  };
  switch (shape) {
    case Shape::kDisc:
      set(random.uniform(6.0, 20.0), random.uniform(0.5, 1.0));
      break;
    case Shape::kStrip:
      set(random.uniform(20.0, 80.0), random.uniform(0.05, 0.15));
      break;
    case Shape::kRectangle:
      set(random.uniform(10.0, 40.0), random.uniform(0.35, 1.0));
      break;
    case Shape::kBigDisc:
      set(random.uniform(66.0, 90.0), random.uniform(0.9, 1.0));
      break;
    case Shape::kSpeck:
      set(random.uniform(1.0, 2.0), random.uniform(0.5, 1.0));
      break;
    case Shape::kAngle:
      set(random.uniform(14.0, 40.0), random.uniform(0.2, 0.4));
      break;
  }
  const bool round = shape == Shape::kDisc || shape == Shape::kBigDisc;
  const double corner = shape == Shape::kAngle ? std::numbers::sqrt2 : std::hypot(1.0, light.slimness);
  light.radius_px = 0.5 * light.size_px * (round ? 1.0 : corner);
  return light;
}

bool isFree(const PlacedLight& light, const std::vector<PlacedLight>& placed) {
  return std::ranges::none_of(placed, [&](const PlacedLight& other) {
    return (other.centre_px - light.centre_px).norm() < other.radius_px + light.radius_px + kGap_px;
  });
}

/// Whole pixels to move a stamp by so that it lies inside and apart from the others; nothing when no room is
/// found.
std::optional<Eigen::Vector2i> placeFor(const PlacedLight& stamp, const std::vector<PlacedLight>& placed,
                                        TrialRandom& random) {
  constexpr int kAttempts = 400;
  const double margin = stamp.radius_px + kBorder_px;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Eigen::Vector2d at(random.uniform(margin, SpuriousScene::kWidth_px - 1 - margin),
                             random.uniform(margin, SpuriousScene::kHeight_px - 1 - margin));
    const Eigen::Vector2i by = (at - stamp.centre_px).array().floor().cast<int>();
    PlacedLight light = stamp;
    light.centre_px += by.cast<double>();
    if (isFree(light, placed)) return by;
  }
  return std::nullopt;
}

}  // namespace

std::string_view id(Shape shape) {
  constexpr std::array<std::string_view, 6> kIds{"disc", "strip", "rectangle", "big_disc", "speck", "angle"};
  return kIds[static_cast<std::size_t>(shape)];
}

SpuriousScene::SpuriousScene(bool small_stock) {
  TrialRandom random(kSeed, kStockStream, 0);
  const auto stamp = [&](Shape shape) {
    Stamp made{randomLight(shape, random), 0, {}};
    made.side_px = 2 * static_cast<int>(std::ceil(made.light.radius_px + 5.0)) + 1;
    const double middle = 0.5 * (made.side_px - 1);
    made.light.centre_px = {middle + random.uniform(-0.5, 0.5), middle + random.uniform(-0.5, 0.5)};
    Light light(made.side_px, made.side_px, 0.0);
    addSurface(light, outlineOf(made.light, random.uniform(0.0, 2.0 * std::numbers::pi)), kSpread_px,
               {1.0, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
    made.share.assign(light.grey.begin(), light.grey.end());
    return made;
  };
  const int kinds = small_stock ? 60 : 1000;
  for (int i = 0; i < 5 * kinds; ++i) discs_.push_back(stamp(Shape::kDisc));
  for (int i = 0; i < kinds; ++i)
    for (const Shape shape :
         {Shape::kStrip, Shape::kRectangle, Shape::kBigDisc, Shape::kSpeck, Shape::kAngle})
      spurious_.push_back(stamp(shape));
}

const SpuriousScene::Stamp& SpuriousScene::anyOf(const std::vector<Stamp>& stamps, double choice) const {
  return stamps[std::min(static_cast<std::size_t>(choice * static_cast<double>(stamps.size())),
                         stamps.size() - 1)];
}

SpuriousFrame SpuriousScene::frame(std::uint64_t index) const {
  TrialRandom random(kSeed, kFrameStream, index);
  SpuriousFrame frame;
  frame.noise = std::exp(random.uniform(std::log(0.5), std::log(kMostContrast / kLeastSnr)));
  std::vector<float> light(static_cast<std::size_t>(kWidth_px) * kHeight_px, static_cast<float>(kGround));
  for (int i = 0; i < kDiscs + kSpurious; ++i) {
    const Stamp& stamp = anyOf(i < kDiscs ? discs_ : spurious_, random.uniform(0.0, 1.0));
    const auto by = placeFor(stamp.light, frame.lights, random);
    if (!by) continue;
    PlacedLight placed = stamp.light;
    placed.centre_px += by->cast<double>();
    placed.contrast = random.uniform(std::max(kLeastContrast, kLeastSnr * frame.noise),
                                     std::min(kMostContrast, kMostSnr * frame.noise));
    frame.lights.push_back(placed);
    for (int y = std::max(0, -by->y()); y < std::min(stamp.side_px, kHeight_px - by->y()); ++y)
      for (int x = std::max(0, -by->x()); x < std::min(stamp.side_px, kWidth_px - by->x()); ++x)
        light[static_cast<std::size_t>((y + by->y()) * kWidth_px + x + by->x())] +=
            static_cast<float>(placed.contrast) *
            stamp.share[static_cast<std::size_t>(y * stamp.side_px + x)];
  }
  frame.image = expose(light, frame.noise, index);
  return frame;
}

camera::GreyImage SpuriousScene::expose(const std::vector<float>& light, double noise,
                                        std::uint64_t index) const {
  TrialRandom random(kSeed, kNoiseStream, index);
  std::vector<std::uint8_t> pixels(light.size());
  const auto sigma = static_cast<float>(noise);
  for (int y = 0; y < kHeight_px; ++y) {
    const float* const normal = normal_.row(kWidth_px, random);
    const float* const from = light.data() + static_cast<std::ptrdiff_t>(y) * kWidth_px;
    std::uint8_t* const to = pixels.data() + static_cast<std::ptrdiff_t>(y) * kWidth_px;
    for (int x = 0; x < kWidth_px; ++x)
      to[x] = static_cast<std::uint8_t>(std::clamp(from[x] + sigma * normal[x] + 0.5F, 0.0F, 255.0F));
  }
  return {kWidth_px, kHeight_px, std::move(pixels)};
}

}  // namespace mirrorarm::benchmarks::vision
