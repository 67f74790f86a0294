#pragma once

#include <atomic>

#include <Eigen/Core>

namespace mirrorarm::simulation {

/// The impaired arm that hangs in the sling, as the robot feels it.
struct SlingArm {
  double weight_n = 15.0;       ///< on the sling while the patient does nothing: forearm and hand
  double damping_n_s_m = 20.0;  ///< of the muscles, against motion
  double stiffness_n_m = 0.0;   ///< of the muscles, towards `rest_B`
  Eigen::Vector3d rest_B = Eigen::Vector3d::Zero();
};

/// The force of that arm on the sling, and what the patient does about it. Setters from any thread, the force
/// from the robot's.
class SlingLoad {
 public:
  explicit SlingLoad(const SlingArm& arm) : arm_(arm) {}

  /// The share of the weight that the patient carries himself, 0 to 1.
  void setEffort(double share) noexcept { effort_.store(share, std::memory_order_relaxed); }
  /// A push or a spasm besides; stays until the next one. A reader may see its parts one cycle apart.
  void push(const Eigen::Vector3d& force_B_n) noexcept;

  /// On the sling at `p_B` that moves with `v_B`, in base axes [N].
  [[nodiscard]] Eigen::Vector3d force(const Eigen::Vector3d& p_B, const Eigen::Vector3d& v_B) const noexcept;

 private:
  const SlingArm arm_;
  std::atomic<double> effort_{0.0};
  std::atomic<double> push_x_{0.0}, push_y_{0.0}, push_z_{0.0};
};

}  // namespace mirrorarm::simulation
