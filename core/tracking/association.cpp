#include "core/tracking/association.h"

namespace mirrorarm::tracking {

int Association::pair(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
                      const RigidTransform& X_YX, double gate_m, std::vector<int>& y_of_x,
                      std::span<const SeenDiscs> discs_of_y) {
  pairs_.clear();
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Eigen::Vector3d moved = X_YX * x[j];
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double squared_distance = (y[k] - moved).squaredNorm();
      if (squared_distance <= gate_m * gate_m)
        pairs_.push_back({static_cast<int>(j), static_cast<int>(k), squared_distance});
    }
  }
  const auto discsOf = [discs_of_y](int point) {
    return discs_of_y.empty() ? SeenDiscs{} : discs_of_y[static_cast<std::size_t>(point)];
  };
  return assignOneToOne(pairs_, discsOf, x.size(), y_of_x);
}

}  // namespace mirrorarm::tracking
