#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"

namespace mirrorarm::tracking {

struct ConstellationSettings {
  /// How far two markers' distance may differ from the model's beyond what the sensor explains [m]: teaching
  /// and skin.
  double tolerance_m = 0.0004;
  double sigmas = 4.0;  ///< of the sensor's own uncertainty of a distance, on top of the tolerance
  double unknown_sigma_m = 0.0002;  ///< of a point without covariance, in each direction
  /// Fits that chance alone would give in such a cloud, expected number a frame: more than this is no proof.
  double max_chance = 1e-3;
  /// Of one target's search: time is bounded whatever a cloud holds. A step takes some 50 to 150 ns.
  int max_steps = 200'000;
};

/// Why the best fit of a target was not taken.
enum class SearchVerdict : std::uint8_t {
  kFound,
  kTooFewMarkers,  ///< no 4 points lie like markers of the target, or chance alone may have made the fit
  kAmbiguous,      ///< another pose, or another target, explains the points as well
  kCutOff,         ///< stopped by max_steps before its best fit was proven the largest and the only one
};

/// One way a target may lie in a cloud.
struct Constellation {
  RigidTransform X_CT = RigidTransform::Identity();
  std::vector<int> point_of_marker;  ///< index into the cloud, -1 for none; one-to-one, also in discs
  int matched = 0;
  double rms_m = 0.0;   ///< of the rigid fit
  double misfit = 0.0;  ///< chi-square of the fit, 3 matched - 6 degrees: of sensor and tolerance together
  double chance = 1.0;  ///< expected number of such fits by chance in this cloud
  /// How much better it explains its points than strangers among them would: logarithm of the odds. Compares
  /// fits, also of different targets, in one cloud.
  double evidence = 0.0;
};

/// What a search says of one target.
struct SearchResult {
  SearchVerdict verdict = SearchVerdict::kTooFewMarkers;
  Constellation best;       ///< good when found; one of several when ambiguous; else a guess at most
  Constellation runner_up;  ///< the best one in another pose; matched is 0 when there is none
};

/// Finds targets in one cloud from nothing: any orientation, any number of them hidden, strangers about.
///
/// Pairs (marker, point) are the vertices of a graph; an edge joins two pairs whose markers lie as far apart
/// as their points do. A set of pairs that all agree is a clique; the largest one is found on bit sets,
/// exactly, with the number of different markers among the candidates as bound. Distances of all targets lie
/// in one index, so that each distance of the cloud is looked up once. A clique whose rigid fit is bad (a
/// mirror image) is passed over. Of points that share a disc one at most is matched.
///
/// Taken for found is a fit of at least 4 markers (3 where the target has no more and the cloud no more than
/// 5 points) that chance would make less than max_chance times a frame, and whose odds against any other pose
/// and against any other target that wants the same points are better than 1 / max_chance: the number of
/// markers counts first, then their misfits. Targets whose markers lie on a line are never found. Source:
/// Bron, Kerbosch, CACM 16, 1973; Tomita, Seki, DMTCS 2003; San Segundo et al., Computers and Operations
/// Research 38(2), 2011; the clique for point sets: Yang, Shi, Carlone, TEASER, T-RO 37(2), 2021.
///
/// One thread. Keeps its buffers: nothing is taken from the heap once they have grown.
class ConstellationSearch {
 public:
  explicit ConstellationSearch(const ConstellationSettings& settings = {});
  ~ConstellationSearch();
  ConstellationSearch(ConstellationSearch&&) noexcept;
  ConstellationSearch& operator=(ConstellationSearch&&) noexcept;

  /// The targets' markers [m], at most kMaxMarkers each; spans are copied. Prepares the index. `tolerances_m`
  /// holds one tolerance a target, or is empty for settings.tolerance_m.
  void setTargets(std::span<const std::span<const Eigen::Vector3d>> targets_T,
                  std::span<const double> tolerances_m = {});

  /// One result a target. Only targets with `wanted[i]` are sought (empty: all); points that one target has
  /// taken are not given to another: the surest choose first. At most kMaxPoints points are considered.
  /// The span stays good until the next call.
  [[nodiscard]] std::span<const SearchResult> run(std::span<const CloudPoint> cloud,
                                                  std::span<const char> wanted = {});

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
