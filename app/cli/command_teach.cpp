#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/point_source.h"
#include "core/tracking/frame_cloud.h"
#include "core/tracking/layout_report.h"
#include "core/tracking/target_file.h"
#include "core/tracking/teacher.h"

namespace mirrorarm::cli {
namespace {

/// Frames at the end of a lesson change its precision a little.
constexpr double kTolerated = 1.1;

struct Options {
  PointInput input;
  std::filesystem::path out;
  std::optional<double> seconds;
  bool all = false;
  double sigma_mm = 1e3 * tracking::TeacherSettings{}.wanted_sigma_m;
};

/// Until the markers are known well enough, or as long as was asked for.
tracking::Teacher watch(PointSource& source, const Options& options) {
  tracking::TeacherSettings settings;
  settings.wanted_sigma_m = 1e-3 * options.sigma_mm;
  tracking::Teacher teacher{settings};
  const bool may_stop = !options.all && !options.seconds;
  TimePoint begin{};
  tracking::FrameCloud cloud;
  for (std::size_t i = 0; i < source.size() && !(may_stop && teacher.isDone()); ++i) {
    const PointFrame frame = source.frame(i);
    if (i == 0) begin = frame.exposed_at;
    if (options.seconds && secondsBetween(begin, frame.exposed_at) > *options.seconds) break;
    cloud.reset(frame.points);
    teacher.add(cloud.points());
  }
  return teacher;
}

std::string reasonOf(tracking::TeachingError error) {
  switch (error) {
    case tracking::TeachingError::kNoFrames:
      return "holds no frame to learn from";
    case tracking::TeachingError::kTooFewMarkers:
      return "shows fewer than 3 markers often enough to learn them";
    case tracking::TeachingError::kCollinear:
      return "shows markers on one line only, which fix no pose";
  }
  return "";
}

std::vector<std::string> warningsOf(const tracking::TaughtTarget& taught, double wanted_sigma_mm) {
  std::vector<std::string> warnings;
  std::ostringstream short_of;
  short_of.precision(2);
  short_of << "imprecise: markers are known to " << 1e3 * taught.sigma_m << " mm only, asked were "
           << wanted_sigma_mm << " mm";
  if (taught.frames_rejected > 0)
    warnings.push_back("left_out: " + std::to_string(taught.frames_rejected) +
                       " frames did not fit and were left out");
  if (taught.target.markers_covariance_m2.empty()) {
    warnings.emplace_back("one_frame: one frame only: how sure the markers are is not known");
  } else if (1e3 * taught.sigma_m > kTolerated * wanted_sigma_mm) {
    warnings.push_back(short_of.str());
  }
  for (auto& line : tracking::layoutWarnings({&taught.target, 1})) warnings.push_back(std::move(line));
  return warnings;
}

std::vector<double> inMillimetres(std::vector<double> lengths_m) {
  for (double& length : lengths_m) length *= 1e3;
  return lengths_m;
}

void tell(const tracking::TaughtTarget& taught, const std::filesystem::path& out,
          const std::vector<std::string>& warnings) {
  std::cout << taught.target.markers_T.size() << " markers from " << taught.frames_used << " frames, "
            << out.string() << "\n";
  for (const auto& line : warnings) std::cout << "warning: " << line << "\n";
}

void teach(const Options& options, Context& context) {
  const auto source = openPoints(options.input);
  const auto name = options.out.stem().string();
  const auto teacher = watch(*source, options);
  const auto taught = teacher.finish(name);
  const auto& input = options.input.clouds.empty() ? options.input.recording : options.input.clouds;
  if (!taught) throw InputRefused(input.string() + ": " + reasonOf(taught.error()));
  orFail(tracking::writeTarget(options.out, taught->target));
  const auto warnings = warningsOf(*taught, options.sigma_mm);
  context.result = {{"markers", taught->target.markers_T.size()},
                    {"frames", taught->frames_used},
                    {"frames_left_out", taught->frames_rejected},
                    {"sigma_mm", nullptr},
                    {"skin_mm", inMillimetres(taught->skin_sigma_m)},
                    {"done", teacher.isDone()},
                    {"warnings", warnings}};
  if (!taught->target.markers_covariance_m2.empty()) context.result["sigma_mm"] = 1e3 * taught->sigma_m;
  if (!context.json) tell(*taught, options.out, warnings);
}

}  // namespace

void addTeach(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(app, context, "teach", "Learn a target from measured points",
                                 "mirrorarm-cli teach recording --seconds 5 --out forearm.yaml");
  const auto options = std::make_shared<Options>();
  addPointInput(*command, options->input);
  command->add_option("--out", options->out, "Target to write; its name is the file's")->required();
  auto* seconds =
      command
          ->add_option("--seconds", options->seconds, "Learn from all of the first seconds, and from no more")
          ->check(CLI::Range(0.001, 86400.0));
  command
      ->add_flag("--all", options->all, "Learn from every frame; else until the markers are known to --sigma")
      ->excludes(seconds);
  command->add_option("--sigma", options->sigma_mm, "Standard deviation of a marker to reach [mm]")
      ->check(CLI::Range(1e-4, 10.0))
      ->capture_default_str();
  command->callback([options, &context] { teach(*options, context); });
}

}  // namespace mirrorarm::cli
