#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/robot/collision.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::robot {

struct PlannerSettings {
  double resolution_rad = 0.01;  ///< see CollisionWorld::firstContact
  double max_joint_range_rad =
      1.0;                   ///< a path that moves one joint further than this from both ends is rejected
  SafeDistances keep{};      ///< of the whole way
  double reserve_m = 0.005;  ///< more than that between the ends: a motion along the way bends off it
  double look_rad = 0.05;    ///< between postures at which a rule is looked at
  Seconds max_time{0.5};     ///< for both searches of a plan; their number of steps is bounded too
  std::uint64_t seed = 1;
};

/// What an arm must keep in every posture, besides its distances.
using PostureRule = std::function<bool(const Joints& q)>;

/// Why there is no path.
enum class PlanError {
  kStartBlocked,
  kGoalBlocked,  ///< or outside the arm's joint ranges
  kNoPath,
  kJointRange,  ///< there is a path, but one that moves a joint too far
};
/// "start_blocked", ...
[[nodiscard]] std::string_view id(PlanError error);

/// No path: why, and what stands in the way where that is known.
struct PlanRefusal {
  PlanError why = PlanError::kNoPath;
  std::optional<Contact> contact = {};  ///< at the blocked end, else the first on the straight joint motion
};

struct PlannedPath {
  static constexpr std::size_t kMostWaypoints = Trajectory::kMaxPieces;

  std::vector<Joints> waypoints;  ///< after the start, the goal last; edges short enough for a spline
  bool direct = true;             ///< the straight joint motion was clear
};

/// Self-collision and obstacles of one arm, and paths around them (searchPath), tried only when the straight
/// joint motion is blocked. One thread. Source: paper section 2.4.
class Planner {
 public:
  /// `attached` are shapes fixed to the flange (link = jointCount()): camera bar, sling.
  Planner(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> obstacles,
          const PlannerSettings& settings);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  [[nodiscard]] bool collides(const Joints& q) const;
  /// What comes nearer to what there than the distances with the reserve; nothing where all is clear.
  [[nodiscard]] std::optional<Contact> contact(const Joints& q) const;
  /// Both ends and the straight joint motion between them.
  [[nodiscard]] bool directIsClear(const Joints& from, const Joints& to) const;
  /// A way that begins nearer to things than `keep` may stay so near, but goes no nearer. `also` must hold
  /// all along a way around something, looked at every `look_rad`; it counts only where it holds at both
  /// ends. The same question finds the same path, unless time runs out first.
  [[nodiscard]] Expected<PlannedPath, PlanRefusal> plan(const Joints& from, const Joints& to,
                                                        const PostureRule& also = {});

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
