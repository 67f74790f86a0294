#include "core/therapy/session_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/therapy/path_lag.h"
#include "core/therapy/repetitions.h"

namespace mirrorarm::therapy {
namespace {

constexpr double kLargestGap_s = 0.25;
constexpr double kLeastShift_m = 0.020, kLeastTurn_rad = 0.35;
constexpr double kPathStep_m = 0.002;

bool isMovement(const Sample& sample) {
  return sample.training && sample.status != tracking::TrackStatus::kLost;
}

/// Pieces of movement without a pause or a gap.
std::vector<PathPair> piecesOf(std::span<const Sample> samples) {
  std::vector<PathPair> pieces;
  const Sample* last = nullptr;
  for (const auto& sample : samples) {
    if (!isMovement(sample)) continue;
    const bool goes_on =
        last && sample.time_s > last->time_s && sample.time_s - last->time_s <= kLargestGap_s;
    if (!goes_on) pieces.emplace_back();
    pieces.back().time_s.push_back(sample.time_s);
    pieces.back().goal.push_back(sample.X_BE_goal.translation());
    pieces.back().reached.push_back(sample.X_BE.translation());
    last = &sample;
  }
  return pieces;
}

/// Sums for the slope and the distance of two paths, one of them delayed.
struct Comparison {
  double count = 0.0, squares = 0.0, goal_squares = 0.0, product = 0.0;
  Eigen::Vector3d goal_sum = Eigen::Vector3d::Zero(), reached_sum = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& goal, const Eigen::Vector3d& reached) {
    count += 1.0;
    squares += (reached - goal).squaredNorm();
    goal_squares += goal.squaredNorm();
    product += goal.dot(reached);
    goal_sum += goal;
    reached_sum += reached;
  }
  [[nodiscard]] double rms() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
  [[nodiscard]] double slope() const {
    const double spread = count > 0.0 ? goal_squares - goal_sum.squaredNorm() / count : 0.0;
    return spread > 0.0 ? (product - goal_sum.dot(reached_sum) / count) / spread : 0.0;
  }
};

/// The end effector against where the goal was `lag_s` earlier, wherever that is known.
Comparison compared(std::span<const PathPair> pieces, double lag_s) {
  Comparison sums;
  for (const auto& piece : pieces)
    for (std::size_t i = 0; i < piece.time_s.size(); ++i) {
      const double earlier = piece.time_s[i] - lag_s;
      if (earlier < piece.time_s.front() || earlier > piece.time_s.back()) continue;
      sums.add(pointAt(piece.time_s, piece.goal, earlier), piece.reached[i]);
    }
  return sums;
}

double wayOf(std::span<const PathPair> pieces) {
  double way = 0.0;
  for (const auto& piece : pieces) {
    Eigen::Vector3d counted = piece.reached.front();
    for (const auto& point : piece.reached)
      if (const double step = (point - counted).norm(); step >= kPathStep_m) {
        way += step;
        counted = point;
      }
  }
  return way;
}

double largestSpeed(std::span<const PathPair> pieces) {
  double speed = 0.0;
  for (const auto& piece : pieces)
    for (std::size_t i = 2; i < piece.time_s.size(); ++i)
      speed = std::max(
          speed, (piece.reached[i] - piece.reached[i - 2]).norm() / (piece.time_s[i] - piece.time_s[i - 2]));
  return speed;
}

void addFollowing(std::span<const PathPair> pieces, SessionMeasures& measures) {
  const auto lag_s = lagOf(pieces);
  const auto felt = compared(pieces, 0.0), shape = compared(pieces, lag_s.value_or(0.0));
  measures.lag_ms = 1e3 * lag_s.value_or(0.0);
  measures.gain = shape.slope();
  measures.felt_error_mm = 1e3 * felt.rms();
  measures.shape_error_mm = 1e3 * shape.rms();
  measures.tool_speed_m_s = largestSpeed(pieces);
  measures.path_mm = 1e3 * wayOf(pieces);
}

void addHealthyArm(std::span<const Sample> samples, SessionMeasures& measures) {
  const auto start = std::ranges::find_if(samples, isMovement);
  std::vector<double> shift_m, turn_rad;
  for (auto sample = start; sample != samples.end(); ++sample) {
    if (!isMovement(*sample)) continue;
    shift_m.push_back((sample->X_BT.translation() - start->X_BT.translation()).norm());
    turn_rad.push_back(angleBetween(start->X_BT, sample->X_BT));
  }
  if (shift_m.empty()) return;
  const double range_m = std::ranges::max(shift_m);
  measures.range_mm = 1e3 * range_m;
  measures.repetitions = range_m >= kLeastShift_m ? countRepetitions(shift_m, kLeastShift_m)
                                                  : countRepetitions(turn_rad, kLeastTurn_rad);
}

void addTracking(std::span<const Sample> samples, SessionMeasures& measures) {
  double tracked = 0.0, rms_sum_m = 0.0;
  for (const auto& sample : samples) {
    if (sample.status != tracking::TrackStatus::kTracked) continue;
    tracked += 1.0;
    rms_sum_m += sample.rms_m;
  }
  measures.frames = static_cast<int>(samples.size());
  if (tracked == 0.0) return;
  measures.tracked_share = tracked / static_cast<double>(samples.size());
  measures.rms_mm = 1e3 * rms_sum_m / tracked;
}

void addForce(std::span<const Sample> samples, SessionMeasures& measures) {
  for (const auto& sample : samples)
    if (sample.force_share)
      measures.force_share = std::max(measures.force_share.value_or(0.0), *sample.force_share);
}

void addHelp(std::span<const Sample> samples, SessionMeasures& measures) {
  double helped = 0.0, levels = 0.0, adapting = 0.0;
  for (const auto& sample : samples) {
    if (!sample.training || !sample.help_level) continue;
    helped += 1.0;
    levels += *sample.help_level;
    if (sample.help_adapts) adapting += 1.0;
  }
  if (helped == 0.0) return;
  measures.help_level = levels / helped;
  measures.help_adapting_share = adapting / helped;
}

double activeTime(std::span<const Sample> samples) {
  double active_s = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double interval = samples[i].time_s - samples[i - 1].time_s;
    if (samples[i - 1].training && samples[i].training && interval <= kLargestGap_s) active_s += interval;
  }
  return active_s;
}

/// Largest of `values` against their limits, joint by joint.
double ratioTo(const robot::Joints& limits, const robot::Joints& values) {
  double ratio = 0.0;
  for (Eigen::Index joint = 0; joint < std::min(limits.size(), values.size()); ++joint)
    if (limits[joint] > 0.0) ratio = std::max(ratio, std::abs(values[joint]) / limits[joint]);
  return ratio;
}

}  // namespace

SessionMeasures measure(std::span<const Sample> samples, const robot::Joints& max_speed_rad_s,
                        const robot::Joints& max_acceleration_rad_s2) {
  SessionMeasures measures;
  addTracking(samples, measures);
  measures.active_s = activeTime(samples);
  addForce(samples, measures);
  addHelp(samples, measures);
  const auto pieces = piecesOf(samples);
  if (std::ranges::count_if(samples, isMovement) < 2) return measures;
  addFollowing(pieces, measures);
  addHealthyArm(samples, measures);
  for (const auto& sample : samples) {
    if (!sample.training) continue;
    measures.joint_speed_ratio =
        std::max(measures.joint_speed_ratio, ratioTo(max_speed_rad_s, sample.v_rad_s));
    measures.joint_acceleration_ratio =
        std::max(measures.joint_acceleration_ratio, ratioTo(max_acceleration_rad_s2, sample.a_rad_s2));
  }
  return measures;
}

}  // namespace mirrorarm::therapy
