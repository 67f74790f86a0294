#include "core/robot/planner.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include "core/robot/joint_ranges.h"

namespace mirrorarm::robot {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kTreeStep_rad = 0.4;
constexpr unsigned kMaxIterations = 4000;  // ends the search by count, not by the clock, on any usual machine
constexpr double kLongestEdge_rad = 0.3;   // of the result, so that a spline through it stays near it
constexpr std::size_t kMaxWaypoints = 32;

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

/// Edges of the trees are proven clear, not sampled.
class ProvenMotion final : public ob::MotionValidator {
 public:
  ProvenMotion(const ob::SpaceInformationPtr& space, const CollisionWorld& world, double finest_rad)
      : MotionValidator(space), world_(world), finest_rad_(finest_rad) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const auto joints = static_cast<Eigen::Index>(si_->getStateDimension());
    return !world_.firstContact(toJoints(from, joints), toJoints(to, joints), finest_rad_);
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
  const CollisionWorld& world_;
  double finest_rad_;
};

ob::ScopedState<> toState(const ob::StateSpacePtr& space, const Joints& q) {
  ob::ScopedState<> state(space);
  for (Eigen::Index j = 0; j < q.size(); ++j) state[static_cast<unsigned>(j)] = q[j];
  return state;
}

double largestStep(const Joints& from, const Joints& to) { return (to - from).cwiseAbs().maxCoeff(); }

}  // namespace

struct Planner::Body {
  Body(const ArmDescription& described, std::span<const Capsule> attached,
       std::span<const Obstacle> obstacles, const PlannerSettings& chosen)
      : world(described, attached, obstacles), settings(chosen), arm(jointRanges(described)) {}

  [[nodiscard]] bool edgeIsClear(const Joints& from, const Joints& to) const {
    return !isBlockedMidway(from, to) && !contactOn(from, to);
  }

  /// Most blocked edges are blocked about their middle: three cheap looks spare the proof.
  [[nodiscard]] bool isBlockedMidway(const Joints& from, const Joints& to) const {
    const auto blocks = [&](double share) { return world.collides(from + share * (to - from)); };
    return blocks(0.5) || blocks(0.25) || blocks(0.75);
  }

  [[nodiscard]] std::optional<Contact> contactOn(const Joints& from, const Joints& to) const {
    return world.firstContact(from, to, settings.resolution_rad);
  }

  /// The joint range that a path may use.
  [[nodiscard]] JointRanges near(const Joints& from, const Joints& to) const {
    const auto room = Joints::Constant(from.size(), settings.max_joint_range_rad);
    return {arm.lower.cwiseMax(from.cwiseMin(to) - room), arm.upper.cwiseMin(from.cwiseMax(to) + room)};
  }

  /// A path within `bounds`, start and goal included; empty when none was found.
  [[nodiscard]] std::vector<Joints> search(const Joints& from, const Joints& to,
                                           const JointRanges& bounds) const {
    if (!bounds.have(from) || !bounds.have(to)) return {};
    const ob::StateSpacePtr space = spaceOf(bounds, settings.seed);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [&](const ob::State* state) { return !world.collides(toJoints(state, from.size())); });
    setup.setStartAndGoalStates(toState(space, from), toState(space, to));
    setup.getSpaceInformation()->setMotionValidator(
        std::make_shared<ProvenMotion>(setup.getSpaceInformation(), world, settings.resolution_rad));
    const auto planner = std::make_shared<og::RRTConnect>(setup.getSpaceInformation());
    planner->setRange(kTreeStep_rad);
    setup.setPlanner(planner);
    setup.setup();
    ob::IterationTerminationCondition counted(kMaxIterations);
    const auto enough = ob::plannerOrTerminationCondition(
        counted, ob::timedPlannerTerminationCondition(0.5 * settings.max_time.count()));
    if (setup.solve(enough) != ob::PlannerStatus::EXACT_SOLUTION) return {};
    std::vector<Joints> path;
    for (const ob::State* state : setup.getSolutionPath().getStates())
      path.push_back(toJoints(state, from.size()));
    return path;
  }

  /// Leaves out what lies between two states that see each other, farthest first, until nothing more can go.
  /// OMPL's own simplifier draws from generators that nobody can seed.
  [[nodiscard]] std::vector<Joints> simplified(const std::vector<Joints>& path) const {
    std::vector<Joints> kept = {path.front()};
    for (std::size_t i = 0; i + 1 < path.size();) {
      std::size_t next = path.size() - 1;
      while (next > i + 1 && !edgeIsClear(path[i], path[next])) --next;
      kept.push_back(path[next]);
      i = next;
    }
    return kept;
  }

  /// Pulls corners in: half-way points of the edges are tried as shortcuts.
  [[nodiscard]] std::vector<Joints> shortened(std::vector<Joints> path) const {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<Joints> before = simplified(path);
      path = {before.front()};
      for (std::size_t i = 1; i < before.size(); ++i) {
        path.push_back(0.5 * (before[i - 1] + before[i]));
        path.push_back(before[i]);
      }
    }
    return simplified(path);
  }

  /// Splits long edges, as far as there is room for way points.
  static std::vector<Joints> split(const std::vector<Joints>& path) {
    double longest = kLongestEdge_rad;
    for (;; longest *= 1.5) {
      std::vector<Joints> points;
      for (std::size_t i = 1; i < path.size(); ++i) {
        const int parts =
            std::max(1, static_cast<int>(std::ceil(largestStep(path[i - 1], path[i]) / longest)));
        for (int part = 1; part <= parts; ++part)
          points.push_back(path[i - 1] + (static_cast<double>(part) / parts) * (path[i] - path[i - 1]));
      }
      if (points.size() <= kMaxWaypoints || points.size() == path.size() - 1) return points;
    }
  }

  CollisionWorld world;
  PlannerSettings settings;
  JointRanges arm;
};

Planner::Planner(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles, const PlannerSettings& settings)
    : body_(std::make_unique<Body>(arm, attached, obstacles, settings)) {
  ompl::msg::noOutputHandler();
}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

bool Planner::collides(const Joints& q) const { return body_->world.collides(q); }

std::optional<Contact> Planner::contact(const Joints& q) const { return body_->world.contact(q); }

bool Planner::directIsClear(const Joints& from, const Joints& to) const {
  return body_->edgeIsClear(from, to);
}

Expected<PlannedPath, PlanRefusal> Planner::plan(const Joints& from, const Joints& to) {
  if (auto contact = body_->world.contact(from))
    return unexpected(PlanRefusal{PlanError::kStartBlocked, std::move(contact)});
  if (!body_->arm.have(to)) return unexpected(PlanRefusal{PlanError::kGoalBlocked});
  if (auto contact = body_->world.contact(to))
    return unexpected(PlanRefusal{PlanError::kGoalBlocked, std::move(contact)});
  auto barrier = body_->contactOn(from, to);
  if (!barrier) return PlannedPath{{to}, true};
  if (const auto path = body_->search(from, to, body_->near(from, to)); !path.empty())
    return PlannedPath{Body::split(body_->shortened(path)), false};
  const bool with_more_range = !body_->search(from, to, body_->arm).empty();
  return unexpected(
      PlanRefusal{with_more_range ? PlanError::kJointRange : PlanError::kNoPath, std::move(barrier)});
}

std::string_view id(PlanError error) {
  switch (error) {
    case PlanError::kStartBlocked:
      return "start_blocked";
    case PlanError::kGoalBlocked:
      return "goal_blocked";
    case PlanError::kNoPath:
      return "no_path";
    case PlanError::kJointRange:
      return "joint_range";
  }
  return "unknown";
}

}  // namespace mirrorarm::robot
