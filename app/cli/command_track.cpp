#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "app/cli/arm_angles.h"
#include "app/cli/commands.h"
#include "app/cli/point_source.h"
#include "app/cli/target_files.h"
#include "app/cli/timing.h"
#include "app/cli/tracker_option.h"
#include "core/tracking/layout_report.h"
#include "core/tracking/pose_file.h"
#include "core/tracking/tracker.h"

namespace mirrorarm::cli {
namespace {

using tracking::PoseRow;
using tracking::Target;
using tracking::TrackedTarget;
using tracking::TrackStatus;

struct Options {
  PointInput input;
  std::vector<std::filesystem::path> targets;
  std::filesystem::path poses;
  std::filesystem::path matches;
  AngleOptions angles;
  tracking::TrackingMethod tracker = tracking::TrackerSettings{}.method;
};

PoseRow rowOf(const PointFrame& frame, const Target& target, const TrackedTarget& answer) {
  PoseRow row{frame.index, target.name, answer, {}};
  for (const int point : answer.point_of_marker)
    if (point >= 0) row.points_C.push_back(frame.points[static_cast<std::size_t>(point)].p_C);
  return row;
}

struct Run {
  std::vector<PoseRow> rows;
  std::vector<double> durations_ms;
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
};

void noteEvents(const tracking::Tracker& tracker, long long index, Run& run) {
  for (std::size_t t = 0; t < tracker.size(); ++t)
    if (const auto event = tracker.event(t); event != tracking::SkinEvent::kNone)
      run.events.push_back({{"index", index}, {"target", tracker.target(t).name}, {"event", id(event)}});
}

Run trackAll(PointSource& source, const std::vector<Target>& targets, tracking::TrackingMethod method) {
  tracking::TrackerSettings settings;
  settings.method = method;
  tracking::Tracker tracker(settings);
  if (const auto* rig = source.rig()) tracker.setRig(*rig);
  tracker.setTargets(targets);
  Run run;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const PointFrame frame = source.frame(i);
    const TimePoint begin = Clock::now();
    const auto answers = tracker.track(frame.points, frame.exposed_at);
    run.durations_ms.push_back(frame.vision_ms + 1e3 * secondsBetween(begin, Clock::now()));
    for (std::size_t t = 0; t < targets.size(); ++t) run.rows.push_back(rowOf(frame, targets[t], answers[t]));
    tracker.learn();
    noteEvents(tracker, frame.index, run);
  }
  return run;
}

double shareOf(const std::vector<PoseRow>& rows, TrackStatus status) {
  const auto count = std::count_if(rows.begin(), rows.end(),
                                   [status](const PoseRow& row) { return row.answer.status == status; });
  return static_cast<double>(count) / static_cast<double>(rows.size());
}

/// Root mean square over all tracked frames; null when there is none.
nlohmann::ordered_json rmsMm(const std::vector<PoseRow>& rows) {
  double sum = 0.0;
  int count = 0;
  for (const auto& row : rows) {
    if (row.answer.status != TrackStatus::kTracked) continue;
    sum += row.answer.rms_m * row.answer.rms_m;
    ++count;
  }
  if (count == 0) return nullptr;
  return 1e3 * std::sqrt(sum / count);
}

nlohmann::ordered_json whyNotTracked(const std::vector<PoseRow>& rows) {
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (const auto& row : rows) {
    if (row.answer.status == TrackStatus::kTracked) continue;
    const std::string reason(id(row.answer.reason));
    counts[reason] = counts.value(reason, 0) + 1;
  }
  return counts;
}

void track(const Options& options, Context& context) {
  const auto targets = readTargets(options.targets);
  const auto arm = armAskedFor(options.angles, targets);
  const auto source = openPoints(options.input);
  const Run run = trackAll(*source, targets, options.tracker);
  orFail(tracking::writePoses(options.poses, run.rows));
  if (!options.matches.empty()) orFail(tracking::writeMatches(options.matches, run.rows));
  const auto warnings = tracking::layoutWarnings(targets);
  context.result = {{"frames", source->size()},
                    {"targets", targets.size()},
                    {"tracked_share", shareOf(run.rows, TrackStatus::kTracked)},
                    {"predicted_share", shareOf(run.rows, TrackStatus::kPredicted)},
                    {"lost_share", shareOf(run.rows, TrackStatus::kLost)},
                    {"not_tracked", whyNotTracked(run.rows)},
                    {"events", run.events},
                    {"warnings", warnings},
                    {"rms_mm", rmsMm(run.rows)},
                    {"ms_per_frame", medianAndP99(run.durations_ms)}};
  if (arm) context.result["arm"] = writeArmAngles(options.angles.angles, *arm, run.rows);
  if (context.json) return;
  std::cout << source->size() << " frames, " << 100.0 * context.result["tracked_share"].get<double>()
            << " % tracked, poses in " << options.poses.string() << "\n";
  for (const auto& line : warnings) std::cout << "warning: " << line << "\n";
}

}  // namespace

void addTrack(CLI::App& app, Context& context) {
  CLI::App* command =
      addCommand(app, context, "track", "Find taught targets in every frame",
                 "mirrorarm-cli track recording --target forearm.yaml --out poses.csv --matches matches.csv");
  const auto options = std::make_shared<Options>();
  addPointInput(*command, options->input);
  command->add_option("--target", options->targets, "Taught target, once for each")->required();
  command->add_option("--out", options->poses, "Table of poses to write")->required();
  command->add_option("--matches", options->matches, "Table of which point was taken for which marker");
  addAngleOptions(*command, options->angles);
  addTrackerOption(*command, options->tracker);
  command->callback([options, &context] { track(*options, context); });
}

}  // namespace mirrorarm::cli
