#include "core/tracking/compatibility_graph.h"

namespace mirrorarm::tracking {

void CompatibilityGraph::reset(int markers, int points) {
  markers_ = markers;
  points_ = points;
  const auto vertices = static_cast<std::size_t>(markers) * static_cast<std::size_t>(points);
  joined_.assign(vertices, 0);
  if (rows_.size() < vertices * static_cast<std::size_t>(markers))
    rows_.resize(vertices * static_cast<std::size_t>(markers));
}

}  // namespace mirrorarm::tracking
