#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/association.h"
#include "core/tracking/softassign.h"
#include "core/tracking/tracked_target.h"
#include "core/tracking/triple_search.h"

namespace mirrorarm::tracking {

struct RegistrationSettings {
  SoftassignSettings softassign;
  bool full_schedule = false;  ///< anneal every registration from softassign.beta_start, as the paper does
  double max_rms_m = 0.003;    ///< of an accepted fit
  int min_matched = 3;         ///< markers that an accepted fit needs
};

/// How a model lies in a cloud.
struct RegistrationResult {
  LostReason reason = LostReason::kNoPoints;  ///< kNone when the fit was accepted
  RigidTransform X_YX = RigidTransform::Identity();
  std::vector<int> y_of_x;  ///< for each model point its cloud point, -1 for none; one-to-one
  int matched = 0;
  double rms_m = 0.0;

  [[nodiscard]] bool isAccepted() const { return reason == LostReason::kNone; }
};

/// Lays one model into one cloud: first identities by softassign, then the least-squares pose over one-to-one
/// pairs, whose gate follows the fit's own misfit: narrow on a rigid body, wide on skin. Keeps its buffers;
/// one thread. Coordinates must be finite. Results stay good until the next call.
class Registration {
 public:
  /// What the points of the cloud were measured from, for the registrations to come; empty when not known.
  void setDiscs(std::span<const SeenDiscs> discs_of_y) { discs_of_y_ = discs_of_y; }

  /// From a guess that puts every marker within about `uncertainty_m` of its point.
  [[nodiscard]] const RegistrationResult& follow(std::span<const Eigen::Vector3d> x,
                                                 std::span<const Eigen::Vector3d> y,
                                                 const RegistrationSettings& settings,
                                                 const RigidTransform& guess_YX, double uncertainty_m);
  /// From nothing, any orientation: guesses by TripleSearch, each followed; the one with most markers wins,
  /// then the one with the least misfit. kNotConverged when the search was cut off before anything fitted.
  [[nodiscard]] const RegistrationResult& search(std::span<const Eigen::Vector3d> x,
                                                 std::span<const Eigen::Vector3d> y,
                                                 const RegistrationSettings& settings);

 private:
  void start(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
             const RigidTransform& guess_YX, double gate_m);
  void settle(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
              const RegistrationSettings& settings);
  void fit(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y);
  void dropWorstPairs(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
                      const RegistrationSettings& settings);

  RegistrationResult result_, best_;
  Softassign softassign_;
  Association association_;
  TripleSearch triples_;
  std::vector<int> y_of_x_before_;
  std::vector<Eigen::Vector3d> x_part_, y_part_;
  std::vector<double> even_;
  std::span<const SeenDiscs> discs_of_y_;
};

}  // namespace mirrorarm::tracking
