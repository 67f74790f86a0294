#include "core/simulation/ridden_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <thread>

namespace mirrorarm::simulation {
namespace {

using robot::Joints;
using robot::LinkFault;
using robot::RobotState;

constexpr std::chrono::milliseconds kLookEvery{1};

Expected<RobotState, LinkFault> firstState(robot::RobotLink& link, Seconds patience) {
  const TimePoint end = Clock::now() + toClock(patience);
  for (;;) {
    const Seconds left = end - Clock::now();
    if (link.setsThePace())
      link.awaitCycle(std::max(left, Seconds(0.0)));
    else
      std::this_thread::sleep_for(kLookEvery);
    const auto state = link.read();
    if (state || left <= Seconds(0.0)) return state;
  }
}

/// Why a robot does not stand at `start`; empty where it does.
std::string misplacement(const Joints& q_rad, const Joints& start) {
  if (q_rad.size() != start.size())
    return "has " + std::to_string(q_rad.size()) + " joints, the bench's arm " + std::to_string(start.size());
  if (!q_rad.allFinite()) return "tells angles that are not finite";
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  Eigen::Index worst = 0;
  if ((q_rad - start).cwiseAbs().maxCoeff(&worst) <= kSamePosture_rad) return "";
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                "does not stand at the bench's start posture and is not moved there by itself: joint %d is "
                "at %.1f degrees, wanted %.1f",
                static_cast<int>(worst) + 1, kDegrees * q_rad[worst], kDegrees * start[worst]);
  return text.data();
}

}  // namespace

Expected<std::unique_ptr<RiddenRobot>, std::string> RiddenRobot::mount(std::unique_ptr<robot::RobotLink> link,
                                                                       const Joints& start,
                                                                       Seconds patience) {
  const auto first = firstState(*link, patience);
  if (!first) return unexpected("the robot tells no state: " + std::string(id(first.error())));
  if (const std::string why = misplacement(first->q_rad, start); !why.empty())
    return unexpected("the robot " + why);
  return std::unique_ptr<RiddenRobot>(new RiddenRobot(std::move(link), *first));
}

Expected<RobotState, LinkFault> RiddenRobot::read() noexcept {
  const auto state = link_->read();
  if (state && state->q_rad.size() == joints_ && state->q_rad.allFinite())
    trail_.add(state->measured_at, state->q_rad);
  return state;
}

}  // namespace mirrorarm::simulation
