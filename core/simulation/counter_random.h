#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace mirrorarm::simulation {

/// The `counter`-th random number of the stream `seed`: no state, so any frame can be made again alone.
/// Source: splitmix64, Steele, Lea, Flood, OOPSLA 2014.
[[nodiscard]] constexpr std::uint64_t counterRandom(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed + (counter + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// The same as an even number in [0, 1).
[[nodiscard]] constexpr double counterUniform(std::uint64_t seed, std::uint64_t counter) {
  return static_cast<double>(counterRandom(seed, counter) >> 11) * 0x1.0p-53;
}

/// The same as a standard normal number, by Box and Muller.
[[nodiscard]] inline double counterNormal(std::uint64_t seed, std::uint64_t counter) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - counterUniform(seed, 2 * counter)));
  return radius * std::cos(2.0 * std::numbers::pi * counterUniform(seed, 2 * counter + 1));
}

}  // namespace mirrorarm::simulation
