#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

struct TripleSearchSettings {
  double tolerance_m = 0.003;              ///< how far a measured side may differ from the model's
  double gate_m = 0.006;                   ///< a marker counts as found when a point lies this near to it
  int max_poses = 6;                       ///< best distinct poses kept
  long long max_comparisons = 10'000'000;  ///< of distances, before the search is cut off: some 10 ms
};

/// First guesses from nothing: triples of cloud points whose three sides fit three markers give a pose each,
/// ranked by how many markers then lie on points. Sides do not change with the body's turn, so any
/// orientation is found at the same cost, with hidden markers and foreign points. Time is bounded by
/// `max_comparisons`. Keeps its buffers; one thread.
class TripleSearch {
 public:
  struct Pose {
    RigidTransform X_YX = RigidTransform::Identity();
    int found = 0;  ///< markers that lie on a point
  };

  /// Best poses first; they stay good until the next call.
  [[nodiscard]] std::span<const Pose> run(std::span<const Eigen::Vector3d> x,
                                          std::span<const Eigen::Vector3d> y,
                                          const TripleSearchSettings& settings);
  /// True when the last search was cut off before all triples were seen.
  [[nodiscard]] bool wasCutOff() const { return cut_off_; }

 private:
  struct Side {
    double length_m = 0.0;
    int from = 0;
    int to = 0;
  };
  void listSides(std::span<const Eigen::Vector3d> points, std::vector<Side>& sides,
                 Eigen::MatrixXd& lengths) const;
  void tryLongestSide(const Side& x_side, const Side& y_side);
  [[nodiscard]] bool isLongestOfFlat(const Side& x_side, int third) const;
  void tryTriple(int j1, int j2, int j3, int k1, int k2, int k3);
  [[nodiscard]] int countFound(const RigidTransform& X_YX, int to_beat) const;
  void keep(const Pose& pose);
  [[nodiscard]] bool isDone() const;

  std::span<const Eigen::Vector3d> x_, y_;
  TripleSearchSettings settings_;
  std::vector<Side> x_sides_, y_sides_;
  Eigen::MatrixXd x_length_, y_length_;
  std::vector<Pose> best_;
  long long comparisons_ = 0;
  bool cut_off_ = false;
};

}  // namespace mirrorarm::tracking
