#pragma once

#include <cstdint>
#include <vector>

#include "core/camera/image.h"
#include "core/simulation/light_image.h"

namespace mirrorarm::simulation {

/// A sensor's noise and range, in grey levels of 0..255. The defaults are those of a Sony ICX445 at 8 bit.
struct SensorSettings {
  double background = 9.0;            ///< ambient light through the band pass, black level
  double electrons_per_level = 30.0;  ///< shot noise: a level has a variance of level / this
  double read_noise = 0.8;            ///< standard deviation in the dark
};

/// Turns light into grey values: shot noise and read noise, rounding, saturation. Noise away from the lit
/// boxes comes from a table at an offset of its own per row, so that a frame costs little more than copying.
/// Equal seeds give equal images.
class Sensor {
 public:
  Sensor(int width_px, int height_px, const SensorSettings& settings);

  [[nodiscard]] camera::GreyImage expose(const LightImage& light, std::uint64_t seed) const;

 private:
  void exposeBox(const LightImage& light, const PixelBox& box, std::uint64_t seed,
                 std::vector<std::uint8_t>& pixels) const;

  int width_ = 0, height_ = 0;
  SensorSettings settings_;
  std::vector<float> noise_;          ///< standard normal numbers
  std::vector<std::uint8_t> ground_;  ///< the unlit sensor
};

}  // namespace mirrorarm::simulation
