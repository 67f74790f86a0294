#include "app/cli/bench_points.h"

#include <limits>

#include "app/cli/command.h"
#include "app/cli/method_option.h"
#include "core/common/resources.h"
#include "core/common/time_source.h"
#include "core/simulation/bench.h"
#include "core/station/bench_equipment.h"
#include "core/therapy/exercise.h"
#include "core/tracking/frame_cloud.h"
#include "core/tracking/teacher.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::cli {
namespace {

constexpr Seconds kPatience{1.0};
constexpr std::size_t kLongestLesson = 240;  // frames

simulation::BenchSettings settingsOf(std::uint64_t seed) {
  simulation::BenchSettings settings;
  settings.resources = resourceFolder();
  settings.legs = station::legsOf(therapy::exerciseOf("reach").value());
  settings.seed = seed;
  return settings;
}

class BenchPoints final : public PointSource {
 public:
  BenchPoints(std::uint64_t seed, vision::CentreMethod method)
      : bench_(orRefuse(simulation::Bench::make(settingsOf(seed), time_))),
        vision_(bench_->rig(), finderOf(method), vision::MatcherSettings{}) {
    bench_->setPatientMoving(true);
  }

  std::size_t size() const override { return std::numeric_limits<std::size_t>::max(); }

  PointFrame frame(std::size_t /*i*/) override {
    const auto images = bench_->cameras().next(kPatience);
    if (!images) throw CommandFailed("the simulated cameras give no image");
    const TimePoint begin = Clock::now();
    const auto& observation = vision_.observe(*images);
    return {static_cast<long long>(images->sequence), observation.exposed_at, observation.points,
            1e3 * secondsBetween(begin, Clock::now())};
  }

  const camera::StereoRig* rig() const override { return &bench_->rig(); }

 private:
  SteadyTime time_;
  std::unique_ptr<simulation::Bench> bench_;
  vision::StereoVision vision_;
};

}  // namespace

std::unique_ptr<PointSource> openBenchPoints(std::uint64_t seed, vision::CentreMethod method) {
  return std::make_unique<BenchPoints>(seed, method);
}

tracking::Target taughtFrom(PointSource& source, const std::string& name) {
  tracking::Teacher teacher{tracking::TeacherSettings{}};
  tracking::FrameCloud cloud;
  for (std::size_t i = 0; i < kLongestLesson && !teacher.isDone(); ++i) {
    cloud.reset(source.frame(i).points);
    teacher.add(cloud.points());
  }
  const auto taught = teacher.finish(name);
  if (!taught) throw CommandFailed("no target could be learnt from what the cameras see");
  return taught->target;
}

}  // namespace mirrorarm::cli
