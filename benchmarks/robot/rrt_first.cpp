#include "benchmarks/robot/rrt_first.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

namespace mirrorarm::benchmarks::robot {
namespace {

namespace ob = ompl::base;
using mirrorarm::robot::JointRanges;
using mirrorarm::robot::Joints;

constexpr double kResolution_rad = 0.01;
constexpr unsigned kMaxIterations = 4000;

std::shared_ptr<ob::RealVectorStateSpace> spaceOf(const JointRanges& ranges) {
  const auto joints = static_cast<unsigned>(ranges.lower.size());
  ob::RealVectorBounds bounds(joints);
  for (unsigned j = 0; j < joints; ++j) {
    bounds.setLow(j, ranges.lower[static_cast<Eigen::Index>(j)]);
    bounds.setHigh(j, ranges.upper[static_cast<Eigen::Index>(j)]);
  }
  auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
  space->setBounds(bounds);
  return space;
}

ob::ScopedState<> toState(const ob::StateSpacePtr& space, const Joints& q) {
  ob::ScopedState<> state(space);
  for (Eigen::Index j = 0; j < q.size(); ++j) state[static_cast<unsigned>(j)] = q[j];
  return state;
}

}  // namespace

std::optional<double> rrtFirstLength(const JointRanges& ranges, const Joints& from, const Joints& to,
                                     const std::function<bool(const Joints&)>& is_clear) {
  ompl::msg::noOutputHandler();
  const auto space = spaceOf(ranges);
  ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const ob::State* state) {
    const double* const values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return is_clear(Eigen::Map<const Eigen::VectorXd>(values, from.size()));
  });
  setup.setStartAndGoalStates(toState(space, from), toState(space, to));
  setup.getSpaceInformation()->setStateValidityCheckingResolution(kResolution_rad /
                                                                  space->getMaximumExtent());
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
  ob::IterationTerminationCondition counted(kMaxIterations);
  if (setup.solve(counted) != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
  return setup.getSolutionPath().length();
}

}  // namespace mirrorarm::benchmarks::robot
