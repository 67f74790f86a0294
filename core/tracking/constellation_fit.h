#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/compatibility_graph.h"
#include "core/tracking/constellation_search.h"
#include "core/tracking/search_cloud.h"

namespace mirrorarm::tracking {

/// How far a point may lie from its marker.
struct Gate {
  double tolerance_m = 0.0;  ///< whatever the sensor does
  double sigmas = 0.0;       ///< of the sensor, on top

  /// Misfit of a point in units of what is allowed: up to 1 it fits.
  [[nodiscard]] double share(const SearchCloud& cloud, int point, const Eigen::Vector3d& off_m) const;
  /// False for a point that is surely farther away than `gates` times what is allowed.
  [[nodiscard]] bool mayReach(const SearchCloud& cloud, int point, const Eigen::Vector3d& off_m,
                              double gates = 1.0) const {
    const double most_m = gates * (tolerance_m + sigmas * cloud.mostSigma(point));
    return off_m.squaredNorm() <= most_m * most_m;
  }
  /// Variance of a marker about its place in the model that the tolerance stands for: two such markers'
  /// distance varies as if it were spread evenly over the tolerance.
  [[nodiscard]] double modelVariance() const { return tolerance_m * tolerance_m / 6.0; }
};

/// Makes a rigid fit of pairings that agree in their distances: leaves out what does not fit the pose, takes
/// in every other marker that finds a point in its gate, and fits again. A stranger that came in through a
/// gate and strains the whole fit is left out in the end. Keeps its buffers.
class ConstellationFit {
 public:
  /// `free[k]` tells whether point k may be matched. All must outlive the fits.
  void begin(std::span<const Eigen::Vector3d> markers_T, const SearchCloud& cloud, std::span<const char> free,
             const Gate& gate);

  /// False when fewer than `least` markers fit one pose, or those that do lie on a line. Leaves `chance`
  /// alone.
  [[nodiscard]] bool run(std::span<const Pairing> pairings, int least, Constellation& fit);

 private:
  void solve(Constellation& fit);
  void leaveOutMisfits(int least, Constellation& fit);
  [[nodiscard]] bool gather(Constellation& fit);
  void leaveOutStrain(int least, Constellation& fit);
  void conclude(Constellation& fit) const;
  [[nodiscard]] double misfitOf(const Constellation& fit) const;
  [[nodiscard]] bool fixesPose();
  [[nodiscard]] Eigen::Vector3d offset(const Constellation& fit, Pairing one) const {
    return cloud_->at(one.point) - fit.X_CT * markers_T_[static_cast<std::size_t>(one.marker)];
  }

  struct Candidate {
    double share = 0.0;
    Pairing pairing;
  };

  std::span<const Eigen::Vector3d> markers_T_;
  const SearchCloud* cloud_ = nullptr;
  std::span<const char> free_;
  Gate gate_;
  std::vector<Pairing> pairings_, gathered_;
  std::vector<Candidate> candidates_;
  std::vector<Eigen::Vector3d> x_, y_;
  std::vector<double> weights_;
};

}  // namespace mirrorarm::tracking
