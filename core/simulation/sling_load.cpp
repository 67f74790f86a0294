#include "core/simulation/sling_load.h"

namespace mirrorarm::simulation {

void SlingLoad::push(const Eigen::Vector3d& force_B_n) noexcept {
  push_x_.store(force_B_n.x(), std::memory_order_relaxed);
  push_y_.store(force_B_n.y(), std::memory_order_relaxed);
  push_z_.store(force_B_n.z(), std::memory_order_relaxed);
}

Eigen::Vector3d SlingLoad::force(const Eigen::Vector3d& p_B, const Eigen::Vector3d& v_B) const noexcept {
  const double carried = effort_.load(std::memory_order_relaxed);
  const Eigen::Vector3d weight(0.0, 0.0, -(1.0 - carried) * arm_.weight_n);
  const Eigen::Vector3d push(push_x_.load(std::memory_order_relaxed), push_y_.load(std::memory_order_relaxed),
                             push_z_.load(std::memory_order_relaxed));
  return weight + push + arm_.stiffness_n_m * (arm_.rest_B - p_B) - arm_.damping_n_s_m * v_B;
}

}  // namespace mirrorarm::simulation
