#include "core/robot/path_search.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

namespace mirrorarm::robot {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kTreeStep_rad = 0.4;
constexpr unsigned kMaxIterations = 4000;  // ends the search by count, not by the clock, on any usual machine

/// OMPL seeds its generators once a process; ours starts anew with every plan, so the same question finds the
/// same answer.
class SeededSampler final : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint64_t seed) : RealVectorStateSampler(space) {
    rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }
};

ob::StateSpacePtr spaceOf(const JointRanges& bounds, std::uint64_t seed) {
  const auto joints = static_cast<unsigned>(bounds.lower.size());
  auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
  ob::RealVectorBounds box(joints);
  for (unsigned j = 0; j < joints; ++j) {
    box.setLow(j, bounds.lower[static_cast<Eigen::Index>(j)]);
    box.setHigh(j, bounds.upper[static_cast<Eigen::Index>(j)]);
  }
  space->setBounds(box);
  space->setStateSamplerAllocator(
      [seed](const ob::StateSpace* of) { return std::make_shared<SeededSampler>(of, seed); });
  return space;
}

Joints toJoints(const ob::State* state, Eigen::Index joints) {
  return Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, joints);
}

/// Edges of the trees are judged as wholes, not sampled.
class WholeMotion final : public ob::MotionValidator {
 public:
  WholeMotion(const ob::SpaceInformationPtr& space, const Passable& passable)
      : MotionValidator(space), passable_(passable) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const auto joints = static_cast<Eigen::Index>(si_->getStateDimension());
    return passable_.along(toJoints(from, joints), toJoints(to, joints));
  }
  /// Asked by planners that keep part of a blocked edge; RRT-Connect does not.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    const bool clear = checkMotion(from, to);
    last_valid.second = clear ? 1.0 : 0.0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, clear ? to : from);
    return clear;
  }

 private:
  const Passable& passable_;
};

ob::ScopedState<> toState(const ob::StateSpacePtr& space, const Joints& q) {
  ob::ScopedState<> state(space);
  for (Eigen::Index j = 0; j < q.size(); ++j) state[static_cast<unsigned>(j)] = q[j];
  return state;
}

/// What RRT-Connect needs to know of the arm and what is around it.
void describe(og::SimpleSetup& setup, const Passable& passable, Eigen::Index joints) {
  setup.setStateValidityChecker(
      [&passable, joints](const ob::State* state) { return passable.at(toJoints(state, joints)); });
  const auto& space = setup.getSpaceInformation();
  space->setMotionValidator(std::make_shared<WholeMotion>(space, passable));
  const auto planner = std::make_shared<og::RRTConnect>(space);
  planner->setRange(kTreeStep_rad);
  setup.setPlanner(planner);
}

}  // namespace

std::vector<Joints> searchPath(const Passable& passable, const Joints& from, const Joints& to,
                               const JointRanges& bounds, const PathSearchSettings& settings) {
  if (!bounds.have(from) || !bounds.have(to)) return {};
  ompl::msg::noOutputHandler();
  const ob::StateSpacePtr space = spaceOf(bounds, settings.seed);
  og::SimpleSetup setup(space);
  describe(setup, passable, from.size());
  setup.setStartAndGoalStates(toState(space, from), toState(space, to));
  setup.setup();
  ob::IterationTerminationCondition counted(kMaxIterations);
  const auto enough = ob::plannerOrTerminationCondition(
      counted, ob::timedPlannerTerminationCondition(settings.max_time.count()));
  if (setup.solve(enough) != ob::PlannerStatus::EXACT_SOLUTION) return {};
  std::vector<Joints> path;
  for (const ob::State* state : setup.getSolutionPath().getStates())
    path.push_back(toJoints(state, from.size()));
  return path;
}

}  // namespace mirrorarm::robot
