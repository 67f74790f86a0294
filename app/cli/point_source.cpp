#include "app/cli/point_source.h"

#include "app/cli/command.h"
#include "app/cli/method_option.h"
#include "core/devices/recording.h"
#include "core/tracking/cloud_file.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::cli {
namespace {

class CloudSource final : public PointSource {
 public:
  explicit CloudSource(const std::filesystem::path& file) : clouds_(orRefuse(tracking::readClouds(file))) {}

  std::size_t size() const override { return clouds_.size(); }

  PointFrame frame(std::size_t i) override {
    const tracking::Cloud& cloud = clouds_[i];
    PointFrame frame{cloud.index, cloud.exposed_at, {}, 0.0};
    frame.points.resize(cloud.points_C.size());
    for (std::size_t k = 0; k < cloud.points_C.size(); ++k) frame.points[k].p_C = cloud.points_C[k];
    return frame;
  }

 private:
  std::vector<tracking::Cloud> clouds_;
};

class RecordingSource final : public PointSource {
 public:
  RecordingSource(const std::filesystem::path& folder, vision::CentreMethod method)
      : recording_(orRefuse(devices::Recording::open(folder))),
        vision_(recording_.rig(), finderOf(method), vision::MatcherSettings{}) {}

  std::size_t size() const override { return recording_.size(); }

  PointFrame frame(std::size_t i) override {
    const camera::StereoFrame images = orRefuse(recording_.frame(i));
    const TimePoint begin = Clock::now();
    const auto& observation = vision_.observe(images);
    const double vision_ms = 1e3 * secondsBetween(begin, Clock::now());
    return {recording_.index(i), observation.exposed_at, observation.points, vision_ms};
  }

  const camera::StereoRig* rig() const override { return &recording_.rig(); }

 private:
  devices::Recording recording_;
  vision::StereoVision vision_;
};

}  // namespace

void addPointInput(CLI::App& command, PointInput& input, Inputs inputs) {
  const bool needed = inputs == Inputs::kOne;
  auto* group = command.add_option_group("Input", needed ? "Exactly one" : "At most one");
  group->add_option("REC", input.recording, "Folder of a recording");
  auto* clouds =
      group->add_option("--clouds", input.clouds, "Table of measured points: index,time_ns,x_m,y_m,z_m");
  group->require_option(needed ? 1 : 0, 1);
  addMethodOption(command, input.method)->excludes(clouds);
}

std::unique_ptr<PointSource> openPoints(const PointInput& input) {
  if (!input.clouds.empty()) return std::make_unique<CloudSource>(input.clouds);
  return std::make_unique<RecordingSource>(input.recording, input.method);
}

}  // namespace mirrorarm::cli
