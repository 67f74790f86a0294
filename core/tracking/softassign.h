#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/match_matrix.h"

namespace mirrorarm::tracking {

/// The paper's parameters (section 3.1). beta is in 1/mm^2, as the paper's figures imply.
struct SoftassignSettings {
  double beta_start = 1e-4;
  double beta_factor = 1.053;
  double beta_max = 1e3;
  int max_mutual_updates = 10;          ///< correspondence <-> pose at one beta
  double tolerated_distance_m = 0.003;  ///< alpha is its square: pairs nearer than this attract
};

struct SoftassignResult {
  RigidTransform X_YX = RigidTransform::Identity();  ///< moves the model onto the cloud
  std::vector<int> y_of_x;  ///< for each model point its cloud point, -1 for none; one-to-one
  int matched = 0;
  double rms_m = 0.0;  ///< over the matched pairs
};

/// Registers model points to a measured cloud: softmax correspondences with slack row and column, normalised
/// in turn, annealed by beta, and the pose by dual quaternions. Computed in the log domain: exp() of equation
/// 23 overflows at the paper's own beta_max. Annealing ends early once every correspondence is decided, which
/// no larger beta would change. Equation 22 of the paper squares a distance that equation 21 has squared
/// already; here Q = d^2 - alpha with d the distance (docs/adr/0002-softassign-units.md). Keeps its buffers
/// from call to call; one thread. Source: paper sections 2.3.1 to 2.3.5; Gold et al., Pattern Recognition
/// 31(8), 1998.
class Softassign {
 public:
  /// `start` is the first guess; without it the clouds' centroids are laid on each other without turning.
  /// With a good guess begin at a beta_start of 1 / (2 u^2), u [mm] how far points may lie from where the
  /// guess puts them: a smaller one would forget the guess. Either cloud may hold points without partner.
  /// Empty clouds give no match. Coordinates must be finite. The result stays good until the next call.
  [[nodiscard]] const SoftassignResult& run(std::span<const Eigen::Vector3d> x,
                                            std::span<const Eigen::Vector3d> y,
                                            const SoftassignSettings& settings,
                                            const std::optional<RigidTransform>& start = std::nullopt);

 private:
  void anneal(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
              const SoftassignSettings& settings);
  bool updateMutually(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y, double beta,
                      double alpha_mm2);
  void assign(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y, double beta,
              double alpha_mm2);
  [[nodiscard]] bool estimatePose(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y);
  void decide(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y);

  SoftassignResult result_;
  MatchMatrix match_;
  Eigen::ArrayXXd Q_mm2_;
  std::vector<Eigen::Vector3d> x_part_, y_part_;
  std::vector<double> weight_;
  std::vector<char> taken_;
};

/// The same without buffers to keep.
[[nodiscard]] SoftassignResult registerSoftassign(std::span<const Eigen::Vector3d> x,
                                                  std::span<const Eigen::Vector3d> y,
                                                  const SoftassignSettings& settings,
                                                  const std::optional<RigidTransform>& start = std::nullopt);

}  // namespace mirrorarm::tracking
