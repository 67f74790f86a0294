#include "core/experiments/scene_trial.h"

#include "core/common/time.h"
#include "core/tracking/teacher.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::experiments {
namespace {

constexpr double kLookAheadRadius_m = 0.04;

vision::FinderSettings finderOf(vision::CentreMethod centres) {
  vision::FinderSettings settings;
  settings.method = centres;
  return settings;
}

tracking::TrackerSettings trackerOf(tracking::TrackingMethod method) {
  tracking::TrackerSettings settings;
  settings.method = method;
  return settings;
}

double millisecondsBetween(TimePoint from, TimePoint to) { return 1e3 * secondsBetween(from, to); }

}  // namespace

FromFile<PlayedScene> play(const simulation::Scene& scene, const std::filesystem::path& resources) {
  auto player = simulation::ScenePlayer::make(scene, resources);
  if (!player) return unexpected(player.error());
  PlayedScene played{player->rig(), {}, {}};
  for (const auto& disc : player->discs_T()) played.markers_T.push_back(disc.p_B);
  for (int i = 0; i < scene.frames; ++i) played.shots.push_back(player->shoot(i));
  return played;
}

Expected<tracking::Target, tracking::TeachingError> teachFrom(const PlayedScene& scene,
                                                              vision::CentreMethod centres) {
  vision::StereoVision vision(scene.rig, finderOf(centres), {});
  tracking::Teacher teacher{tracking::TeacherSettings{}};
  std::vector<tracking::CloudPoint> cloud;
  for (const auto& shot : scene.shots) {
    tracking::collectCloud(vision.observe(shot.frame).points, cloud);
    teacher.add(cloud);
  }
  auto taught = teacher.finish("target");
  if (!taught) return unexpected(taught.error());
  return taught->target;
}

std::vector<TrialFrame> track(const PlayedScene& scene, const tracking::Target& target,
                              const Approach& approach, bool look_ahead) {
  vision::StereoVision vision(scene.rig, finderOf(approach.centres), {});
  tracking::Tracker tracker(trackerOf(approach.tracking));
  tracker.setRig(scene.rig);
  tracker.setTargets({&target, 1});
  std::vector<Eigen::Vector3d> expected_C;
  std::vector<TrialFrame> frames;
  for (const auto& shot : scene.shots) {
    const TimePoint start = Clock::now();
    const auto& seen = vision.observe(shot.frame);
    const TimePoint between = Clock::now();
    const auto& answer = tracker.track(seen.points, shot.frame.exposed_at).front();
    frames.push_back(
        {answer, shot.X_CT, millisecondsBetween(start, between), millisecondsBetween(between, Clock::now())});
    tracker.learn();
    expected_C.clear();
    if (look_ahead && answer.status == tracking::TrackStatus::kTracked)
      for (const auto& p_T : target.markers_T) expected_C.push_back(answer.X_CT * p_T);
    vision.expect(expected_C, kLookAheadRadius_m);
  }
  return frames;
}

}  // namespace mirrorarm::experiments
