#include <sstream>

#include "app/cli/experiment_commands.h"
#include "app/cli/latency_figure.h"
#include "core/common/resources.h"
#include "core/experiments/paper_figures.h"

namespace mirrorarm::cli {
namespace {

using namespace experiments;

struct Options {
  int moves = 24;
  unsigned seed = 20151213;
};

/// What the command measures.
struct Measured {
  LatencyResult reach;      ///< moves as an arm makes them
  LatencyResult trapezoid;  ///< moves as an industrial robot makes them
  std::vector<SwingResult> swings;
};

constexpr double kSwing_s = 20.0;

template <class Result>
Result orRefuse(Expected<Result, std::string> result) {
  if (!result) throw InputRefused(result.error());
  return std::move(*result);
}

Measured measured(const Options& options) {
  const auto resources = resourceFolder();
  return {orRefuse(measureLatency(resources, MoveProfile::kMinimumJerk, options.moves, options.seed)),
          orRefuse(measureLatency(resources, MoveProfile::kTrapezoid, options.moves, options.seed)),
          orRefuse(measureSwing(resources, kSwing_s, options.seed))};
}

nlohmann::ordered_json jsonOf(const LatencyStatistics& of) {
  return {
      {"mean_ms", of.mean_ms}, {"median_ms", of.median_ms}, {"p95_ms", of.p95_ms}, {"worst_ms", of.worst_ms}};
}

nlohmann::ordered_json jsonOf(const LatencyResult& of) {
  return {
      {"onset", jsonOf(of.onset)},
      {"lag_at_50mm", jsonOf(of.lag_at_50mm)},
      {"paper_scheme", {{"onset", jsonOf(of.paper_onset)}, {"lag_at_50mm", jsonOf(of.paper_lag_at_50mm)}}}};
}

/// Of the directions in which the paper's joint speeds allow the swing: all but x.
double swingError_mm(const std::vector<SwingResult>& swings) {
  return std::max(swings[1].rms_error_mm, swings[2].rms_error_mm);
}

nlohmann::ordered_json jsonOf(const Measured& of) {
  const LatencyChain& chain = of.reach.chain;
  nlohmann::ordered_json result = {{"onset_ms", of.reach.onset.mean_ms},
                                   {"lag_at_50mm_ms", of.reach.lag_at_50mm.mean_ms},
                                   {"rms_error_mm", swingError_mm(of.swings)},
                                   {"chain",
                                    {{"exposure", chain.exposure},
                                     {"transfer", chain.transfer},
                                     {"detection", chain.detection},
                                     {"tracking", chain.tracking},
                                     {"planning", chain.planning},
                                     {"servo", chain.servo},
                                     {"arm", chain.arm}}},
                                   {"moves", of.reach.moves.size()},
                                   {"minimum_jerk", jsonOf(of.reach)},
                                   {"trapezoid", jsonOf(of.trapezoid)},
                                   {"paper", {{"onset_ms", paper::kLatency_ms}}}};
  for (const SwingResult& swing : of.swings)
    result["swings"].push_back(
        {{"direction", {swing.direction.x(), swing.direction.y(), swing.direction.z()}},
         {"rms_error_mm", swing.rms_error_mm},
         {"lag_ms", swing.lag_ms}});
  return result;
}

std::string line(const std::string& name, const LatencyStatistics& ours,
                 const LatencyStatistics& paper_scheme) {
  return "| " + name + " | " + fixedNumber(ours.mean_ms, 1) + " | " + fixedNumber(ours.p95_ms, 1) + " | " +
         fixedNumber(ours.worst_ms, 1) + " | " + fixedNumber(paper_scheme.mean_ms, 1) + " |\n";
}

std::string tableOf(const Measured& of) {
  std::ostringstream out;
  out << "# Latency of the robot that follows\n\nA second robot moves the target by 100 mm, "
      << of.reach.moves.size() << " times to and fro along y and z, from rest to rest; frames at 24 Hz meet "
      << "each start at another time.\n\n"
      << "| [ms] | mean | 95 % | worst | the paper's scheme as a model, mean |\n|---|---|---|---|---|\n"
      << line("arm-like move: onset (1 mm)", of.reach.onset, of.reach.paper_onset)
      << line("arm-like move: at 50 mm", of.reach.lag_at_50mm, of.reach.paper_lag_at_50mm)
      << line("robot-like move: onset (1 mm)", of.trapezoid.onset, of.trapezoid.paper_onset)
      << line("robot-like move: at 50 mm", of.trapezoid.lag_at_50mm, of.trapezoid.paper_lag_at_50mm)
      << "| measured in the paper | " << paper::kLatency_ms << " | | | |\n\n"
      << "Following 0.3 Hz of 50 mm amplitude:\n\n| along | rms error [mm] | lag [ms] |\n|---|---|---|\n";
  const char* axes[] = {"x (faster than the joints' limits allow)", "y", "z"};
  for (std::size_t i = 0; i < of.swings.size(); ++i)
    out << "| " << axes[i] << " | " << fixedNumber(of.swings[i].rms_error_mm, 2) << " | "
        << fixedNumber(of.swings[i].lag_ms, 1) << " |\n";
  const LatencyChain& chain = of.reach.chain;
  out << "\nWhat lies between the movement and the answer [ms]; prediction makes up for most of it:\n\n"
      << "| exposure | transfer | detection | tracking | planning | servo | arm "
         "|\n|---|---|---|---|---|---|---|\n| "
      << fixedNumber(chain.exposure, 1) << " | " << fixedNumber(chain.transfer, 1) << " | "
      << fixedNumber(chain.detection, 2) << " | " << fixedNumber(chain.tracking, 2) << " | "
      << fixedNumber(chain.planning, 2) << " | " << fixedNumber(chain.servo, 1) << " | "
      << fixedNumber(chain.arm, 1) << " |\n";
  return out.str();
}

}  // namespace

void addExperimentLatency(CLI::App& experiment, Context& context) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = addExperimentCommand(
      experiment, context, "latency", "Delay of the robot that follows (section 3.2, figure 7)", [options] {
        const Measured results = measured(*options);
        return ExperimentReport{jsonOf(results),
                                tableOf(results),
                                {{"latency.svg", latencyFigure(results.reach)},
                                 {"latency_moments.csv", momentsCsv(results.reach)}}};
      });
  command->add_option("--moves", options->moves, "Moves of the target, of each kind")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of all that is random")->capture_default_str();
}

}  // namespace mirrorarm::cli
