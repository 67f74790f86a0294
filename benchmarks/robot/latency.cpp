#include "core/experiments/latency.h"

#include <filesystem>
#include <stdexcept>

#include "benchmarks/robot/suite.h"
#include "benchmarks/statistics.h"
#include "core/common/resources.h"
#include "core/experiments/paper_figures.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using namespace experiments;

constexpr double kOnsetGoal_ms = 90.0, kLagGoal_ms = 60.0, kErrorGoal_mm = 5.0;
constexpr double kStepGoal_ms = 0.3, kStepTailGoal_ms = 1.0;
constexpr double kSwing_s = 20.0, kQuickSwing_s = 7.0;

template <class Result>
Result orThrow(Expected<Result, std::string> result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(*result);
}

std::vector<Figure> figures(const LatencyStatistics& of) {
  return {{"mean", of.mean_ms, "ms"}, {"95 %", of.p95_ms, "ms"}, {"worst", of.worst_ms, "ms"}};
}

void addMoves(Report& report, const LatencyResult& result, const std::string& kind, bool judged) {
  report.rows.push_back({"",
                         "onset (1 mm), " + kind,
                         judged ? "<= 90 ms mean" : "",
                         figures(result.onset),
                         {{"the paper", paper::kLatency_ms, "ms"},
                          {"its scheme as a model, mean", result.paper_onset.mean_ms, "ms"}},
                         {}});
  if (judged) report.rows.back().pass = result.onset.mean_ms <= kOnsetGoal_ms;
  report.rows.push_back({"",
                         "lag at 50 mm, " + kind,
                         "<= 60 ms mean",
                         figures(result.lag_at_50mm),
                         {{"the paper's scheme as a model, mean", result.paper_lag_at_50mm.mean_ms, "ms"}},
                         result.lag_at_50mm.mean_ms <= kLagGoal_ms});
}

void addChain(Report& report, const LatencyChain& chain) {
  report.rows.push_back({"",
                         "between movement and answer",
                         "",
                         {{"exposure", chain.exposure, "ms"},
                          {"transfer", chain.transfer, "ms"},
                          {"detection", chain.detection, "ms"},
                          {"tracking", chain.tracking, "ms"},
                          {"planning", chain.planning, "ms"},
                          {"servo", chain.servo, "ms"},
                          {"arm", chain.arm, "ms"}},
                         {},
                         {}});
}

void addStep(Report& report, const std::vector<double>& follow_ms) {
  const double median = quantile(follow_ms, 0.5), tail = quantile(follow_ms, 0.99);
  report.rows.push_back({"",
                         "follower step, direct path clear: prediction to checked motion",
                         "<= 0.3 ms median, 1 ms p99",
                         {{"median", median, "ms"}, {"p99", tail, "ms"}},
                         {},
                         median <= kStepGoal_ms && tail <= kStepTailGoal_ms});
}

void addSwing(Report& report, const SwingResult& swing, const std::string& axis, bool judged) {
  report.rows.push_back({"",
                         "0.3 Hz, 50 mm along " + axis,
                         judged ? "<= 5 mm rms" : "",
                         {{"rms error", swing.rms_error_mm, "mm"}, {"lag", swing.lag_ms, "ms"}},
                         {},
                         {}});
  if (judged) report.rows.back().pass = swing.rms_error_mm <= kErrorGoal_mm;
}

}  // namespace

void measureLatency(Run& run) {
  const std::filesystem::path resources = resourceFolder();
  const int moves = run.trials(32, 2);
  const auto seed = static_cast<unsigned>(kSeed);
  const LatencyResult reach =
      orThrow(experiments::measureLatency(resources, MoveProfile::kMinimumJerk, moves, seed));
  addMoves(run.report, reach, "moves as an arm makes them", true);
  addChain(run.report, reach.chain);
  addStep(run.report, reach.run.follow_ms);
  addMoves(run.report, orThrow(experiments::measureLatency(resources, MoveProfile::kTrapezoid, moves, seed)),
           "even acceleration of 0.3 m/s^2", false);
  const auto swings = orThrow(measureSwing(resources, run.options.quick ? kQuickSwing_s : kSwing_s, seed));
  addSwing(run.report, swings[1], "y", true);
  addSwing(run.report, swings[2], "z", true);
  addSwing(run.report, swings[0], "x: faster than the joints may go", false);
}

}  // namespace mirrorarm::benchmarks::robot
