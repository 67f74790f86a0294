#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/chance.h"
#include "core/tracking/clique_search.h"
#include "core/tracking/constellation_fit.h"
#include "core/tracking/constellation_search.h"
#include "core/tracking/search_cloud.h"

namespace mirrorarm::tracking {

/// Two points as far apart as two markers: `a` is `k` and `b` is `l`, or `a` is `l` and `b` is `k`.
struct Agreement {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  std::uint8_t k = 0;
  std::uint8_t l = 0;
};

/// What one target is sought in.
struct Sought {
  std::span<const Eigen::Vector3d> markers_T;
  double tolerance_m = 0.0;
  const SearchCloud* cloud = nullptr;
  std::span<const Agreement> agreements;  ///< all that this target and cloud have
  std::span<const char> free;             ///< of each point, whether it may be matched
};

/// Makes `result` that of a target of so many markers that was not found. Keeps its buffers.
void forget(SearchResult& result, std::size_t markers);

/// Finds one target in one cloud: largest clique, rigid fit, runner-up, chance, verdict. Keeps its buffers.
class TargetSearch : private CliqueJudge {
 public:
  explicit TargetSearch(const ConstellationSettings& settings) : settings_(settings) {}

  /// What `sought` refers to must outlive the call.
  void run(const Sought& sought, SearchResult& result);

 private:
  [[nodiscard]] bool mayJoin(std::span<const Pairing, 3> three, Pairing next) override;
  [[nodiscard]] int judge(std::span<const Pairing> clique) override;

  void buildGraph();
  void seekBest();
  void seekRunnerUp();
  [[nodiscard]] int judgeBest(std::span<const Pairing> clique);
  [[nodiscard]] int judgeRunnerUp(std::span<const Pairing> clique);
  void markExplained();
  [[nodiscard]] bool isSamePose(const Constellation& other) const;
  void weigh();
  void weigh(Constellation& fit) const;
  [[nodiscard]] double pairRate() const;
  [[nodiscard]] double densityAround(const RigidTransform& X_CT) const;
  [[nodiscard]] SearchVerdict verdict() const;
  [[nodiscard]] bool areOddsClear() const;
  [[nodiscard]] const Eigen::Vector3d& marker(int index) const {
    return sought_.markers_T[static_cast<std::size_t>(index)];
  }

  ConstellationSettings settings_;
  Sought sought_;
  SearchResult* result_ = nullptr;
  Gate gate_;
  double gate_m_ = 0.0;   ///< typical, of a point
  double width_m_ = 0.0;  ///< typical, of a distance
  int free_points_ = 0;
  int agreements_ = 0;  ///< of free points
  int least_ = 0;       ///< markers of a fit
  int steps_ = 0;
  bool seeks_runner_up_ = false;
  Crowd crowd_;
  double gain_ = 0.0;          ///< evidence of one more marker without misfit
  double misfit_scale_ = 1.0;  ///< how many times larger the best fit's misfit is than it should be
  CompatibilityGraph graph_;
  CliqueSearch cliques_;
  ConstellationFit fit_;
  Constellation trial_;
  std::vector<PointSet> explained_;  ///< by the best fit, for each marker
};

}  // namespace mirrorarm::tracking
