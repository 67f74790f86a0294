#include "core/control/planning_desk.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::control {

void PlanningDesk::answer() {
  const PlanQuestion* const question = questions_.take();
  if (question == nullptr) return;
  PlanAnswer answer{.number = question->number};
  robot::PostureRule keeps_in_view;
  if (sees_ && question->sight)
    keeps_in_view = [this, &sight = *question->sight](const robot::Joints& q) { return sees_(q, sight); };
  const auto path = planner_.plan(question->from, question->to, keeps_in_view);
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
