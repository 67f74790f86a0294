#include "core/tracking/clique_search.h"

#include <limits>

namespace mirrorarm::tracking {
namespace {

constexpr int kMarkersOfAStep = 8;  // whose candidates are looked through in the time of one step

int takeFirst(MarkerSet& markers) {
  const int marker = std::countr_zero(markers);
  markers &= markers - 1;
  return marker;
}

}  // namespace

bool CliqueSearch::run(const CompatibilityGraph& graph, int least, std::span<const PointSet> known,
                       CliqueJudge& judge, int& steps) {
  graph_ = &graph;
  judge_ = &judge;
  known_ = known;
  least_ = least;
  steps_ = &steps;
  begin();
  return steps > 0;
}

void CliqueSearch::begin() {
  const int markers = graph_->markers();
  candidates_.resize(static_cast<std::size_t>(markers) * static_cast<std::size_t>(markers + 1));
  chosen_.clear();
  chosen_.reserve(static_cast<std::size_t>(markers));
  MarkerSet open = 0;
  for (int marker = 0; marker < markers; ++marker) {
    PointSet supported;
    for (int point = 0; point < graph_->points(); ++point)
      if (countBits(graph_->joined({marker, point})) + 1 >= least_) supported |= PointSet::of(point);
    candidates(0)[marker] = supported;
    if (!supported.isEmpty()) open |= markerBit(marker);
  }
  expand(open, known_.empty());
}

/// Decides one marker after the other: each of its candidates, then none of them.
void CliqueSearch::expand(MarkerSet open, bool is_new) {
  while (open != 0 && depth() + countBits(open) >= least_ && (is_new || holdNew(open))) {
    const int marker = fewestPoints(open);
    open &= ~markerBit(marker);
    PointSet points = candidates(depth())[marker];
    while (!points.isEmpty()) {
      if (*steps_ <= 0) return;
      --*steps_;
      choose({marker, points.takeFirst()}, open, is_new);
    }
  }
}

void CliqueSearch::choose(Pairing next, MarkerSet open, bool is_new) {
  const int joined = countBits(open & graph_->joined(next));
  if (depth() + 1 + joined < least_) return;
  *steps_ -= joined / kMarkersOfAStep;
  open = keepNeighbours(next, open);
  is_new = is_new || !isKnown(next);
  chosen_.push_back(next);
  if (depth() == 3) open = siftByHandedness(open);
  if (open != 0)
    expand(open, is_new);
  else if (depth() >= least_ && is_new)
    least_ = judge_->judge(chosen_);
  chosen_.pop_back();
}

/// Candidates of the next depth: those that agree with `next` too.
MarkerSet CliqueSearch::keepNeighbours(Pairing next, MarkerSet open) {
  const PointSet* from = candidates(depth());
  const PointSet* row = graph_->rowOf(next);
  PointSet* to = candidates(depth() + 1);
  MarkerSet kept = 0;
  for (MarkerSet rest = open & graph_->joined(next); rest != 0;) {
    const int marker = takeFirst(rest);
    to[marker] = from[marker] & row[marker];
    if (!to[marker].isEmpty()) kept |= markerBit(marker);
  }
  return kept;
}

MarkerSet CliqueSearch::siftByHandedness(MarkerSet open) {
  const std::span<const Pairing, 3> three(chosen_.data(), 3);
  MarkerSet kept = 0;
  for (MarkerSet rest = open; rest != 0;) {
    const int marker = takeFirst(rest);
    PointSet joining;
    for (PointSet points = candidates(depth())[marker]; !points.isEmpty();) {
      const int point = points.takeFirst();
      if (judge_->mayJoin(three, {marker, point})) joining |= PointSet::of(point);
    }
    candidates(depth())[marker] = joining;
    if (!joining.isEmpty()) kept |= markerBit(marker);
  }
  return kept;
}

int CliqueSearch::fewestPoints(MarkerSet open) const {
  int fewest = std::numeric_limits<int>::max(), chosen = 0;
  while (open != 0) {
    const int marker = takeFirst(open);
    const int count = candidates(depth())[marker].count();
    if (count >= fewest) continue;
    if (count == 1) return marker;
    fewest = count;
    chosen = marker;
  }
  return chosen;
}

bool CliqueSearch::isKnown(Pairing one) const {
  return !known_.empty() && known_[static_cast<std::size_t>(one.marker)].holds(one.point);
}

bool CliqueSearch::holdNew(MarkerSet open) const {
  while (open != 0) {
    const int marker = takeFirst(open);
    if (!candidates(depth())[marker].without(known_[static_cast<std::size_t>(marker)]).isEmpty()) return true;
  }
  return false;
}

}  // namespace mirrorarm::tracking
