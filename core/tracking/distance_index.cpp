#include "core/tracking/distance_index.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::size_t kStretches = 2048;

}  // namespace

void DistanceIndex::build(std::span<const std::vector<Eigen::Vector3d>> targets_T) {
  entries_.clear();
  for (std::size_t target = 0; target < targets_T.size(); ++target)
    for (std::size_t a = 0; a < targets_T[target].size(); ++a)
      for (std::size_t b = a + 1; b < targets_T[target].size(); ++b)
        entries_.push_back({static_cast<float>((targets_T[target][a] - targets_T[target][b]).norm()),
                            static_cast<std::uint16_t>(target), static_cast<std::uint8_t>(a),
                            static_cast<std::uint8_t>(b)});
  std::ranges::sort(entries_, {}, &Entry::distance_m);
  const float longest_m = entries_.empty() ? 0.0F : entries_.back().distance_m;
  stretches_per_m_ = longest_m > 0.0F ? static_cast<float>(kStretches) / longest_m : 0.0F;
  first_.assign(kStretches + 2, entries_.size());
  for (std::size_t i = entries_.size(); i-- > 0;)
    first_[static_cast<std::size_t>(entries_[i].distance_m * stretches_per_m_)] = i;
  for (std::size_t stretch = first_.size() - 1; stretch-- > 0;)
    first_[stretch] = std::min(first_[stretch], first_[stretch + 1]);
}

}  // namespace mirrorarm::tracking
