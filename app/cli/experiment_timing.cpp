#include <sstream>

#include "app/cli/experiment_commands.h"
#include "core/common/resources.h"
#include "core/experiments/paper_figures.h"
#include "core/experiments/timing.h"

namespace mirrorarm::cli {
namespace {

using experiments::ChainTiming;
using experiments::DurationStatistics;
using experiments::TimingResult;

nlohmann::ordered_json jsonOf(const DurationStatistics& of) {
  return {{"median_ms", of.median_ms}, {"mean_ms", of.mean_ms}, {"std_ms", of.std_ms}, {"p99_ms", of.p99_ms}};
}

nlohmann::ordered_json jsonOf(const ChainTiming& of) {
  return {{"vision", jsonOf(of.vision)},
          {"tracking", jsonOf(of.tracking)},
          {"whole", jsonOf(of.whole)},
          {"tracked_share", of.tracked_share}};
}

nlohmann::ordered_json jsonOf(const TimingResult& of) {
  nlohmann::ordered_json result = jsonOf(of.ours.whole);
  result["markers"] = of.markers;
  result["frames"] = of.frames;
  result["ours"] = jsonOf(of.ours);
  result["paper_method"] = jsonOf(of.paper);
  result["paper"] = {{"mean_ms", experiments::paper::kMean_ms}, {"std_ms", experiments::paper::kStd_ms}};
  return result;
}

std::string line(const std::string& name, const DurationStatistics& of) {
  return "| " + name + " | " + fixedNumber(of.median_ms, 3) + " | " + fixedNumber(of.mean_ms, 3) + " +- " +
         fixedNumber(of.std_ms, 3) + " | " + fixedNumber(of.p99_ms, 3) + " |\n";
}

std::string tableOf(const TimingResult& of) {
  std::ostringstream out;
  out << "# Computing time\n\nFrom both images (1296 x 964) to pose and covariance, " << of.markers
      << " markers on a moving forearm, " << of.frames << " frames, this machine.\n\n"
      << "| | median [ms] | mean +- std [ms] | p99 [ms] |\n|---|---|---|---|\n"
      << line("ours: images to points", of.ours.vision) << line("ours: points to pose", of.ours.tracking)
      << line("ours: whole", of.ours.whole) << line("the paper's method: images to points", of.paper.vision)
      << line("the paper's method: points to pose", of.paper.tracking)
      << line("the paper's method: whole", of.paper.whole) << "| paper, its machine of 2015 | | "
      << experiments::paper::kMean_ms << " +- " << experiments::paper::kStd_ms << " | |\n";
  return out.str();
}

ExperimentReport measure() {
  const auto result = experiments::measureTiming(resourceFolder());
  if (!result) throw InputRefused(result.error());
  return {jsonOf(*result), tableOf(*result)};
}

}  // namespace

void addExperimentTiming(CLI::App& experiment, Context& context) {
  addExperimentCommand(experiment, context, "timing", "Computing time with ten markers (section 3.2)",
                       measure);
}

}  // namespace mirrorarm::cli
