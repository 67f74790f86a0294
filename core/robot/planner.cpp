#include "core/robot/planner.h"

#include "core/robot/joint_ranges.h"
#include "core/robot/path_search.h"
#include "core/robot/path_shortening.h"

namespace mirrorarm::robot {
namespace {

SafeDistances withReserve(const SafeDistances& keep, double reserve_m) {
  return {keep.self_m + reserve_m, keep.obstacle_m + reserve_m};
}

/// Both ends of a way may be as near to things as the arm may be at all, the start even nearer.
class Admitted {
 public:
  Admitted(CollisionWorld& world, const Joints& from, const Joints& to, const SafeDistances& keep)
      : world_(world) {
    world_.admit(from);
    world_.admit(to, keep);
  }
  ~Admitted() { world_.admitNothing(); }
  Admitted(const Admitted&) = delete;
  Admitted& operator=(const Admitted&) = delete;

 private:
  CollisionWorld& world_;
};

}  // namespace

struct Planner::Body {
  Body(const ArmDescription& described, std::span<const Capsule> attached,
       std::span<const Obstacle> obstacles, const PlannerSettings& chosen)
      : world(described, attached, obstacles, withReserve(chosen.keep, chosen.reserve_m)),
        settings(chosen),
        arm(jointRanges(described)) {}

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

  [[nodiscard]] bool keeps(const PostureRule& rule, const Joints& from, const Joints& to) const {
    const int looks = 1 + static_cast<int>((to - from).cwiseAbs().maxCoeff() / settings.look_rad);
    for (int i = 1; i <= looks; ++i)
      if (!rule(from + (static_cast<double>(i) / looks) * (to - from))) return false;
    return true;
  }

  [[nodiscard]] Passable passable() const {
    return {[this](const Joints& q) { return !world.collides(q); },
            [this](const Joints& from, const Joints& to) { return edgeIsClear(from, to); }};
  }
  [[nodiscard]] Passable passable(const PostureRule& rule) const {
    return {[this, &rule](const Joints& q) { return rule(q) && !world.collides(q); },
            [this, &rule](const Joints& from, const Joints& to) {
              return keeps(rule, from, to) && edgeIsClear(from, to);
            }};
  }

  /// The joint range that a path may use.
  [[nodiscard]] JointRanges near(const Joints& from, const Joints& to) const {
    const auto room = Joints::Constant(from.size(), settings.max_joint_range_rad);
    return {arm.lower.cwiseMax(from.cwiseMin(to) - room), arm.upper.cwiseMin(from.cwiseMax(to) + room)};
  }

  /// Around `barrier`, which blocks the straight way.
  [[nodiscard]] Expected<PlannedPath, PlanRefusal> around(Contact barrier, const Joints& from,
                                                          const Joints& to, const Passable& where) const {
    const PathSearchSettings search{0.5 * settings.max_time, settings.seed};
    if (const auto path = searchPath(where, from, to, near(from, to), search); !path.empty())
      return PlannedPath{splitEdges(shortened(path, where), PlannedPath::kMostWaypoints), false};
    const bool with_more_range = !searchPath(where, from, to, arm, search).empty();
    return unexpected(
        PlanRefusal{with_more_range ? PlanError::kJointRange : PlanError::kNoPath, std::move(barrier)});
  }

  CollisionWorld world;
  PlannerSettings settings;
  JointRanges arm;
};

Planner::Planner(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles, const PlannerSettings& settings)
    : body_(std::make_unique<Body>(arm, attached, obstacles, settings)) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

bool Planner::collides(const Joints& q) const { return body_->world.collides(q); }

std::optional<Contact> Planner::contact(const Joints& q) const { return body_->world.contact(q); }

bool Planner::directIsClear(const Joints& from, const Joints& to) const {
  return body_->edgeIsClear(from, to);
}

Expected<PlannedPath, PlanRefusal> Planner::plan(const Joints& from, const Joints& to,
                                                 const PostureRule& also) {
  if (!body_->arm.have(to)) return unexpected(PlanRefusal{PlanError::kGoalBlocked});
  const Admitted ends(body_->world, from, to, body_->settings.keep);
  if (auto contact = body_->world.contact(from))
    return unexpected(PlanRefusal{PlanError::kStartBlocked, std::move(contact)});
  if (auto contact = body_->world.contact(to))
    return unexpected(PlanRefusal{PlanError::kGoalBlocked, std::move(contact)});
  auto barrier = body_->contactOn(from, to);
  if (!barrier) return PlannedPath{{to}, true};
  const bool is_ruled = also && also(from) && also(to);
  return body_->around(std::move(*barrier), from, to, is_ruled ? body_->passable(also) : body_->passable());
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
