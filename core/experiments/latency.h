#pragma once

#include <functional>

#include "core/experiments/follow_run.h"
#include "core/experiments/held_moves.h"

namespace mirrorarm::experiments {

/// Of several moves [ms].
struct LatencyStatistics {
  double mean_ms = 0.0, median_ms = 0.0, p95_ms = 0.0, worst_ms = 0.0;
};

/// How late the following robot was in one move; not a number where it did not come so far.
struct MoveLatency {
  HeldMove move;
  double onset_ms = 0.0;        ///< from one millimetre of the target's way to one of the tool's
  double lag_at_50mm_ms = 0.0;  ///< the same at 50 mm
};

/// What lies between a movement and the answer, on average [ms]. Prediction makes up for part of it.
struct LatencyChain {
  double exposure = 0.0;   ///< waiting for the next frame, and the light
  double transfer = 0.0;   ///< from the camera
  double detection = 0.0;  ///< images to points
  double tracking = 0.0;   ///< points to pose
  double planning = 0.0;   ///< pose to checked motion
  double servo = 0.0;      ///< until the first command of it
  double arm = 0.0;        ///< until the arm is there
};

struct LatencyResult {
  MoveProfile profile = MoveProfile::kMinimumJerk;
  std::vector<MoveLatency> moves;
  LatencyStatistics onset, lag_at_50mm;
  LatencyStatistics paper_onset, paper_lag_at_50mm;  ///< of the paper's scheme as a model, same moves
  LatencyChain chain;
  FollowRun run;
  std::vector<FollowMoment> paper_moments;
};

/// Section 3.2, figure 7: a second robot moves the target by 100 mm, to and fro in all directions; the delay
/// of the robot that follows at the onset and half-way.
[[nodiscard]] Expected<LatencyResult, std::string> measureLatency(const std::filesystem::path& resources,
                                                                  MoveProfile profile, int moves,
                                                                  unsigned seed);

struct SwingResult {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double rms_error_mm = 0.0;  ///< distance of the tool from where it belongs at that time
  double lag_ms = 0.0;        ///< delay that explains it best
};

/// Following 0.3 Hz of 50 mm amplitude along each axis of B.
[[nodiscard]] Expected<std::vector<SwingResult>, std::string> measureSwing(
    const std::filesystem::path& resources, double duration_s, unsigned seed);

/// Where the onset is taken.
inline constexpr double kOnset_m = 0.001;

/// How far somebody has come in a move at a moment [m].
using WayOf = std::function<double(const FollowMoment&)>;
/// Along the move since its start, of the target or of the tool.
[[nodiscard]] WayOf wayAlong(const HeldMove& move, const std::vector<FollowMoment>& moments,
                             Eigen::Vector3d FollowMoment::*who);
/// Time at which the way first reaches `way_m`, from `from_s` on; not a number where it never does.
[[nodiscard]] double timeOfWay(const std::vector<FollowMoment>& moments, double from_s, double way_m,
                               const WayOf& wayOf);

}  // namespace mirrorarm::experiments
