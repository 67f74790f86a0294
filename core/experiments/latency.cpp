#include "core/experiments/latency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/common/quantile.h"
#include "core/experiments/paper_scheme.h"

namespace mirrorarm::experiments {
namespace {

constexpr double kHalfWay_m = 0.050;
constexpr double kAfter_s = 1.0;  // recorded after the last move
constexpr double kSwing_hz = 0.3, kSwing_m = 0.050, kSwingIn_s = 4.0;

LatencyStatistics statisticsOf(const std::vector<MoveLatency>& moves, double MoveLatency::*which) {
  std::vector<double> values;
  for (const MoveLatency& move : moves) values.push_back(move.*which);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {sum / static_cast<double>(values.size()), quantile(values, 0.5), quantile(values, 0.95),
          quantile(values, 1.0)};
}

MoveLatency latencyOf(const HeldMove& move, const std::vector<FollowMoment>& moments) {
  const WayOf target = wayAlong(move, moments, &FollowMoment::target_m);
  const WayOf tool = wayAlong(move, moments, &FollowMoment::tool_m);
  const auto late_ms = [&](double way_m) {
    return 1e3 *
           (timeOfWay(moments, move.start_s, way_m, tool) - timeOfWay(moments, move.start_s, way_m, target));
  };
  return {move, late_ms(kOnset_m), late_ms(kHalfWay_m)};
}

std::vector<MoveLatency> latenciesOf(const std::vector<HeldMove>& moves,
                                     const std::vector<FollowMoment>& moments) {
  std::vector<MoveLatency> latencies;
  for (const HeldMove& move : moves) latencies.push_back(latencyOf(move, moments));
  return latencies;
}

LatencyChain chainOf(const FollowRun& run, double rate_hz) {
  return {.exposure = 1e3 * (0.5 / rate_hz + 0.5 * run.exposure_s),
          .transfer = 1e3 * run.transfer_s,
          .detection = quantile(run.vision_ms, 0.5),
          .tracking = quantile(run.tracking_ms, 0.5),
          .planning = quantile(run.follow_ms, 0.5),
          .servo = 1e3 * run.handover_s,
          .arm = 1e3 * run.arm_delay_s};
}

/// Starts softly, so that the swing begins without a jump in speed.
double swingAt(double time_s) {
  const double t = time_s - kFollowingFrom_s;
  if (t <= 0.0) return 0.0;
  return std::min(1.0, t / kSwingIn_s) * kSwing_m * std::sin(2.0 * std::numbers::pi * kSwing_hz * t);
}

SwingResult swingOf(const FollowRun& run, const Eigen::Vector3d& direction) {
  double squares = 0.0, behind = 0.0, speeds = 0.0;
  int count = 0;
  for (std::size_t i = 1; i < run.moments.size(); ++i) {
    const FollowMoment &before = run.moments[i - 1], &now = run.moments[i];
    if (now.time_s < kFollowingFrom_s + kSwingIn_s + 1.0) continue;
    const Eigen::Vector3d error = now.target_m - now.tool_m;
    const double speed = direction.dot(now.target_m - before.target_m) / (now.time_s - before.time_s);
    squares += error.squaredNorm();
    behind += speed * direction.dot(error);
    speeds += speed * speed;
    ++count;
  }
  return {direction, 1e3 * std::sqrt(squares / count), 1e3 * behind / speeds};
}

}  // namespace

WayOf wayAlong(const HeldMove& move, const std::vector<FollowMoment>& moments,
               Eigen::Vector3d FollowMoment::*who) {
  const Eigen::Vector3d along = move.shift_m.normalized();
  const auto begin = std::ranges::lower_bound(moments, move.start_s, {}, &FollowMoment::time_s);
  const double zero = along.dot((*begin).*who);
  return [=](const FollowMoment& moment) { return along.dot(moment.*who) - zero; };
}

double timeOfWay(const std::vector<FollowMoment>& moments, double from_s, double way_m, const WayOf& wayOf) {
  for (std::size_t i = 1; i < moments.size(); ++i) {
    if (moments[i].time_s < from_s) continue;
    const double before = wayOf(moments[i - 1]), now = wayOf(moments[i]);
    if (before < way_m && now >= way_m)
      return moments[i - 1].time_s +
             (moments[i].time_s - moments[i - 1].time_s) * (way_m - before) / (now - before);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Expected<LatencyResult, std::string> measureLatency(const std::filesystem::path& resources,
                                                    MoveProfile profile, int moves, unsigned seed) {
  const auto planned = movesToAndFro(profile, moves, kFollowingFrom_s + 0.5, seed);
  FollowRunSettings settings{.resources = resources,
                             .path = [&](double t) { return shiftAt(planned, t); },
                             .duration_s = planned.back().end_s() + kAfter_s,
                             .seed = seed};
  auto run = runFollowing(settings);
  if (!run) return unexpected(run.error());
  LatencyResult result;
  result.profile = profile;
  auto paper = followAsThePaper(settings, *run);
  if (!paper) return unexpected(paper.error());
  result.moves = latenciesOf(planned, run->moments);
  const auto paper_moves = latenciesOf(planned, *paper);
  result.paper_onset = statisticsOf(paper_moves, &MoveLatency::onset_ms);
  result.paper_lag_at_50mm = statisticsOf(paper_moves, &MoveLatency::lag_at_50mm_ms);
  result.paper_moments = std::move(*paper);
  result.onset = statisticsOf(result.moves, &MoveLatency::onset_ms);
  result.lag_at_50mm = statisticsOf(result.moves, &MoveLatency::lag_at_50mm_ms);
  result.chain = chainOf(*run, settings.rate_hz);
  result.run = std::move(*run);
  return result;
}

Expected<std::vector<SwingResult>, std::string> measureSwing(const std::filesystem::path& resources,
                                                             double duration_s, unsigned seed) {
  std::vector<SwingResult> results;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = Eigen::Vector3d::Unit(axis);
    const auto run = runFollowing({.resources = resources,
                                   .path = [&](double t) { return Eigen::Vector3d(swingAt(t) * direction); },
                                   .duration_s = kFollowingFrom_s + duration_s,
                                   .seed = seed});
    if (!run) return unexpected(run.error());
    results.push_back(swingOf(*run, direction));
  }
  return results;
}

}  // namespace mirrorarm::experiments
