#include "core/experiments/follow_run.h"

#include "core/common/time_source.h"
#include "core/station/bench_equipment.h"
#include "core/station/lockstep_station.h"
#include "core/station/session_script.h"

namespace mirrorarm::experiments {
namespace {

using station::SessionScript;

constexpr auto kStep = std::chrono::milliseconds(2);
constexpr TimePoint kStart{std::chrono::seconds(1)};

/// Bench, station and operator of one run.
class Runner {
 public:
  Runner(std::unique_ptr<simulation::Bench> bench, std::shared_ptr<const simulation::HeldMotion> held,
         ManualTime& time, double duration_s)
      : bench_(std::move(bench)),
        held_(std::move(held)),
        time_(time),
        station_(station::equipmentOf(*bench_), settings_, time_),
        script_(station_, {.teaching = Seconds(6.0), .training = Seconds(duration_s)}, [](bool) {}) {
    bench_->setPatientMoving(true);
    tool_start_ = toolNow();
    target_start_ = held_->poseAt(0.0).translation();
  }

  Expected<FollowRun, std::string> run(double duration_s) {
    FollowRun result;
    for (double t = 0.0; t < duration_s; t = elapsed()) {
      station_.advanceTo(time_.now() + kStep);
      if (script_.step(time_.now()) == SessionScript::Progress::kFailed) return unexpected(script_.failure());
      if (script_.stops() > 0) return unexpected(std::string("the robot was stopped on the way"));
      if (elapsed() < kFollowingFrom_s) continue;
      if (script_.seen().control.phase != therapy::Phase::kTraining)
        return unexpected(std::string("the robot does not follow in time"));
      note(result);
    }
    result.arm_delay_s = script_.seen().control.arm_delay_s;
    result.handover_s = settings_.follower.handover.count();
    return result;
  }

 private:
  [[nodiscard]] double elapsed() const { return secondsBetween(kStart, time_.now()); }
  [[nodiscard]] Eigen::Vector3d toolNow() const {
    return (bench_->truthAt(time_.now()).X_BF * bench_->X_FE()).translation();
  }

  void note(FollowRun& result) {
    result.moments.push_back({elapsed(),
                              held_->poseAt(elapsed() - kPhaseBehind_s).translation() - target_start_,
                              toolNow() - tool_start_});
    const auto& seen = script_.seen();
    if (!seen.frame || seen.frame->frame.sequence == last_sequence_) return;
    last_sequence_ = seen.frame->frame.sequence;
    result.vision_ms.push_back(seen.frame->vision_ms);
    result.tracking_ms.push_back(seen.frame->tracking_ms);
    result.follow_ms.push_back(seen.control.follow_ms);
  }

  const station::StationSettings settings_{};
  std::unique_ptr<simulation::Bench> bench_;
  std::shared_ptr<const simulation::HeldMotion> held_;
  ManualTime& time_;
  station::LockstepStation station_;
  SessionScript script_;
  Eigen::Vector3d tool_start_, target_start_;
  std::uint64_t last_sequence_ = 0;
};

}  // namespace

Expected<FollowRun, std::string> runFollowing(const FollowRunSettings& settings) {
  const auto scene = simulation::readScene(settings.resources / "scenes/ur5_target.yaml", settings.resources);
  if (!scene) return unexpected(describe(scene.error()));
  auto held = simulation::HeldMotion::make(*scene, settings.resources, settings.path, settings.duration_s);
  if (!held) return unexpected(describe(held.error()));
  const std::shared_ptr<const simulation::HeldMotion> motion = std::move(*held);
  simulation::BenchSettings bench_settings;
  bench_settings.resources = settings.resources;
  bench_settings.held = motion;
  bench_settings.rate_hz = settings.rate_hz;
  bench_settings.seed = settings.seed;
  bench_settings.own_pace = false;
  ManualTime time;
  time.set(kStart);
  auto bench = simulation::Bench::make(bench_settings, time);
  if (!bench) return unexpected(describe(bench.error()));
  Runner runner(std::move(*bench), motion, time, settings.duration_s);
  auto run = runner.run(settings.duration_s);
  if (!run) return run;
  run->exposure_s = bench_settings.exposure.count();
  run->transfer_s = bench_settings.transfer.count();
  return run;
}

}  // namespace mirrorarm::experiments
