#include "core/experiments/timing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/common/quantile.h"

namespace mirrorarm::experiments {
namespace {

constexpr std::size_t kWarmUp = 24;
constexpr int kFrames = 120;  // 300 MB of images: no cache holds them
constexpr int kRounds = 4;

DurationStatistics statisticsOf(const std::vector<double>& durations_ms) {
  const auto count = static_cast<double>(durations_ms.size());
  DurationStatistics result;
  result.median_ms = quantile(durations_ms, 0.5);
  result.p99_ms = quantile(durations_ms, 0.99);
  result.mean_ms = std::accumulate(durations_ms.begin(), durations_ms.end(), 0.0) / count;
  double squares = 0.0;
  for (const double each : durations_ms) squares += (each - result.mean_ms) * (each - result.mean_ms);
  result.std_ms = std::sqrt(squares / count);
  return result;
}

ChainTiming timingOf(const PlayedScene& scene, const tracking::Target& target, const Approach& approach,
                     int rounds) {
  std::vector<double> vision, tracking, whole;
  double tracked = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const auto frames = track(scene, target, approach, true);
    for (std::size_t i = kWarmUp; i < frames.size(); ++i) {
      vision.push_back(frames[i].vision_ms);
      tracking.push_back(frames[i].tracking_ms);
      whole.push_back(frames[i].vision_ms + frames[i].tracking_ms);
      tracked += frames[i].answer.status == tracking::TrackStatus::kTracked ? 1.0 : 0.0;
    }
  }
  const double share = tracked / static_cast<double>(whole.size());
  return {statisticsOf(std::move(vision)), statisticsOf(std::move(tracking)), statisticsOf(std::move(whole)),
          share};
}

}  // namespace

Expected<TimingResult, std::string> measureTiming(const std::filesystem::path& resources) {
  auto scene = simulation::readScene(resources / "scenes" / "forearm_exercise.yaml", resources);
  if (!scene) return unexpected(describe(scene.error()));
  scene->frames = std::min(scene->frames, kFrames);
  const auto played = play(*scene, resources);
  if (!played) return unexpected(describe(played.error()));
  const tracking::Target target{scene->target.name, scene->target.marker_diameter_m, played->markers_T, {}};
  TimingResult result;
  result.markers = static_cast<int>(target.markers_T.size());
  result.ours = timingOf(*played, target, {}, kRounds);
  result.paper = timingOf(*played, target, kPaperApproach, 1);
  result.frames = kRounds * (scene->frames - static_cast<int>(kWarmUp));
  return result;
}

}  // namespace mirrorarm::experiments
