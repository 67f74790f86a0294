#include "app/cli/point_source.h"

#include "app/cli/command.h"
#include "core/tracking/cloud_file.h"

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

}  // namespace

void addPointInput(CLI::App& command, PointInput& input) {
  auto* group = command.add_option_group("Input", "Exactly one");
  group->add_option("--clouds", input.clouds, "Table of measured points: index,time_ns,x_m,y_m,z_m");
  group->require_option(1);
}

std::unique_ptr<PointSource> openPoints(const PointInput& input) {
  return std::make_unique<CloudSource>(input.clouds);
}

}  // namespace mirrorarm::cli
