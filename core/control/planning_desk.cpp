#include "core/control/planning_desk.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::control {

void PlanningDesk::answer() {
  const PlanQuestion* const question = questions_.take();
  if (question == nullptr) return;
  PlanAnswer answer{.number = question->number};
  const auto path = planner_.plan(question->from, question->to);
  if (path) {
    assert(path->waypoints.size() <= answer.waypoints.size());
    std::ranges::copy(path->waypoints, answer.waypoints.begin());
    answer.waypoint_count = path->waypoints.size();
  } else {
    answer.refusal = path.error();
  }
  answers_.put(answer);
}

}  // namespace mirrorarm::control
