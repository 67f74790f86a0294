#pragma once

#include <cstdint>
#include <random>

namespace mirrorarm::benchmarks {

/// The random numbers of one trial: they depend on the seed and the trial alone, not on threads or order.
class TrialRandom {
 public:
  TrialRandom(std::uint64_t seed, std::uint64_t stream, std::uint64_t trial) {
    std::seed_seq sequence{seed, stream, trial};
    engine_.seed(sequence);
  }

  [[nodiscard]] double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// 0 .. count - 1.
  [[nodiscard]] int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  [[nodiscard]] double normal() { return normal_(engine_); }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace mirrorarm::benchmarks
