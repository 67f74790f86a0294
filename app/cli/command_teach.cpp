#include <iostream>
#include <limits>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/point_source.h"
#include "core/tracking/target_file.h"
#include "core/tracking/teacher.h"

namespace mirrorarm::cli {
namespace {

struct Options {
  PointInput input;
  std::filesystem::path out;
  double seconds = std::numeric_limits<double>::infinity();
};

tracking::Teacher watch(PointSource& source, double seconds) {
  tracking::Teacher teacher{tracking::TeacherSettings{}};
  TimePoint begin{};
  std::vector<Eigen::Vector3d> cloud_C;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const PointFrame frame = source.frame(i);
    if (i == 0) begin = frame.exposed_at;
    if (secondsBetween(begin, frame.exposed_at) > seconds) break;
    vision::collectPreferred(frame.points, cloud_C);
    teacher.add(cloud_C);
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

nlohmann::ordered_json warningsOf(const tracking::TaughtTarget& taught) {
  nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
  if (taught.frames_rejected > 0)
    warnings.push_back(std::to_string(taught.frames_rejected) + " frames did not fit and were left out");
  if (taught.frames_used < 2) warnings.push_back("one frame only: how sure the markers are is not known");
  return warnings;
}

void teach(const Options& options, Context& context) {
  const auto source = openPoints(options.input);
  const auto name = options.out.stem().string();
  const auto taught = watch(*source, options.seconds).finish(name);
  const auto& input = options.input.clouds.empty() ? options.input.recording : options.input.clouds;
  if (!taught) throw InputRefused(input.string() + ": " + reasonOf(taught.error()));
  orFail(tracking::writeTarget(options.out, taught->target));
  context.result = {{"markers", taught->target.markers_T.size()},
                    {"frames", taught->frames_used},
                    {"frames_left_out", taught->frames_rejected},
                    {"sigma_mm", nullptr},
                    {"warnings", warningsOf(*taught)}};
  if (taught->frames_used >= 2) context.result["sigma_mm"] = 1e3 * taught->sigma_m;
  if (!context.json)
    std::cout << taught->target.markers_T.size() << " markers from " << taught->frames_used << " frames, "
              << options.out.string() << "\n";
}

}  // namespace

void addTeach(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(app, context, "teach", "Learn a target from measured points",
                                 "mirrorarm-cli teach recording --seconds 5 --out forearm.yaml");
  const auto options = std::make_shared<Options>();
  addPointInput(*command, options->input);
  command->add_option("--out", options->out, "Target to write; its name is the file's")->required();
  command->add_option("--seconds", options->seconds, "Learn from the first seconds only")
      ->check(CLI::Range(0.001, 86400.0));
  command->callback([options, &context] { teach(*options, context); });
}

}  // namespace mirrorarm::cli
