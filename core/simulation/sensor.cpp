#include "core/simulation/sensor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {
namespace {

constexpr std::size_t kTable = 1 << 17;
constexpr std::uint64_t kBoxStream = 0x80000000u;  // rows of boxes draw other offsets than rows of the ground

std::uint8_t greyOf(float expected, float noise, const SensorSettings& settings) {
  const float shot = std::max(expected, 0.0F) / static_cast<float>(settings.electrons_per_level);
  const auto read = static_cast<float>(settings.read_noise);
  const float level = expected + std::sqrt(shot + read * read) * noise;
  return static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
}

}  // namespace

Sensor::Sensor(int width_px, int height_px, const SensorSettings& settings)
    : width_(width_px), height_(height_px), settings_(settings), noise_(kTable), ground_(kTable) {
  std::mt19937 random(20151213);
  std::normal_distribution<float> normal;
  for (auto& value : noise_) value = normal(random);
  for (std::size_t i = 0; i < kTable; ++i)
    ground_[i] = greyOf(static_cast<float>(settings_.background), noise_[i], settings_);
}

camera::GreyImage Sensor::expose(const LightImage& light, std::uint64_t seed) const {
  const auto width = static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> pixels(width * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const auto offset = counterRandom(seed, static_cast<std::uint64_t>(y)) % (kTable - width);
    std::memcpy(pixels.data() + static_cast<std::size_t>(y) * width, ground_.data() + offset, width);
  }
  for (const PixelBox& box : light.lit()) exposeBox(light, box, seed, pixels);
  return {width_, height_, std::move(pixels)};
}

void Sensor::exposeBox(const LightImage& light, const PixelBox& box, std::uint64_t seed,
                       std::vector<std::uint8_t>& pixels) const {
  const auto background = static_cast<float>(settings_.background);
  for (int y = box.top; y < box.bottom; ++y) {
    const auto offset = counterRandom(seed, kBoxStream + static_cast<std::uint64_t>(y)) %
                        (kTable - static_cast<std::size_t>(width_));
    const float* const noise = noise_.data() + offset;
    const float* const lit = light.row(y);
    std::uint8_t* const row = pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    for (int x = box.left; x < box.right; ++x) row[x] = greyOf(background + lit[x], noise[x], settings_);
  }
}

}  // namespace mirrorarm::simulation
