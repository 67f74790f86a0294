#include "benchmarks/vision/noise_table.h"

#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::vision {

NoiseTable::NoiseTable() : normal_(1 << 20) {
  constexpr std::uint64_t kStream = 53;
  TrialRandom random(kSeed, kStream, 0);
  for (float& value : normal_) value = static_cast<float>(random.normal());
}

}  // namespace mirrorarm::benchmarks::vision
