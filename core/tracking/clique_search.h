#pragma once

#include <span>
#include <vector>

#include "core/tracking/compatibility_graph.h"

namespace mirrorarm::tracking {

/// Says what a clique search is to make of the sets of pairings that it meets.
class CliqueJudge {
 public:
  virtual ~CliqueJudge() = default;
  /// Whether a pairing may join three that hold: distances do not tell a body from its mirror image.
  [[nodiscard]] virtual bool mayJoin(std::span<const Pairing, 3> three, Pairing next) = 0;
  /// Told of a clique of at least the size asked for; returns the size asked for from now on, not less than
  /// before.
  [[nodiscard]] virtual int judge(std::span<const Pairing> clique) = 0;
};

/// Finds the large cliques of a compatibility graph, exactly: branch and bound. A marker can be one point at
/// most, so the number of different markers among the candidates bounds what can still join; the marker with
/// fewest candidates is decided first. Source: Tomita, Seki, DMTCS 2003; San Segundo et al., Computers and
/// Operations Research 38(2), 2011. Keeps its buffers.
class CliqueSearch {
 public:
  /// Tells `judge` of cliques of at least `least` pairings that hold a pairing outside `known` (a set of
  /// points for each marker; empty: every clique). `steps` counts down with every pairing
  /// looked at, and with the candidates looked through for it, may be lowered by the judge for its own work,
  /// and ends the search below 1: false then.
  [[nodiscard]] bool run(const CompatibilityGraph& graph, int least, std::span<const PointSet> known,
                         CliqueJudge& judge, int& steps);

 private:
  void begin();
  void expand(MarkerSet open, bool is_new);
  void choose(Pairing next, MarkerSet open, bool is_new);
  [[nodiscard]] MarkerSet keepNeighbours(Pairing next, MarkerSet open);
  [[nodiscard]] MarkerSet siftByHandedness(MarkerSet open);
  [[nodiscard]] int fewestPoints(MarkerSet open) const;
  [[nodiscard]] bool isKnown(Pairing one) const;
  [[nodiscard]] bool holdNew(MarkerSet open) const;
  [[nodiscard]] int depth() const { return static_cast<int>(chosen_.size()); }
  /// Candidates after `depth` choices, a set for each marker.
  [[nodiscard]] PointSet* candidates(int depth) {
    return candidates_.data() + static_cast<std::size_t>(depth) * static_cast<std::size_t>(graph_->markers());
  }
  [[nodiscard]] const PointSet* candidates(int depth) const {
    return candidates_.data() + static_cast<std::size_t>(depth) * static_cast<std::size_t>(graph_->markers());
  }

  const CompatibilityGraph* graph_ = nullptr;
  CliqueJudge* judge_ = nullptr;
  std::span<const PointSet> known_;
  int least_ = 0;
  int* steps_ = nullptr;
  std::vector<Pairing> chosen_;
  std::vector<PointSet> candidates_;
};

}  // namespace mirrorarm::tracking
