#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "core/common/atomic_file.h"
#include "core/common/resources.h"
#include "core/devices/recording.h"
#include "core/simulation/scene_player.h"
#include "core/tracking/target_file.h"

namespace mirrorarm::cli {
namespace {

struct Request {
  std::filesystem::path scene;
  std::filesystem::path out;
};

tracking::Target targetOf(const simulation::Scene& scene, const simulation::ScenePlayer& player) {
  tracking::Target target;
  target.name = scene.target.name;
  target.marker_diameter_m = scene.target.marker_diameter_m;
  for (const auto& disc : player.discs_T()) target.markers_T.push_back(disc.p_B);
  return target;
}

void writeMeta(const std::filesystem::path& file, const simulation::Scene& scene) {
  orFail(writeWhole(file, [&scene](std::ostream& out) {
    out << "made_by: mirrorarm-cli simulate\nversion: " << MIRRORARM_VERSION
        << "\nscene: " << scene.file.filename().string() << "\nseed: " << scene.seed
        << "\nrate_hz: " << scene.rate_hz << "\ncarried_by: " << simulation::id(scene.target.carried_by)
        << "\ncovered_share: " << scene.covered_share << "\n";
  }));
}

void shootAll(const simulation::Scene& scene, simulation::ScenePlayer& player,
              devices::RecordingWriter& writer) {
  for (int i = 0; i < scene.frames; ++i) {
    const auto shot = player.shoot(i);
    orFail(writer.add(shot.frame));
    writer.addTruth({i, scene.target.name, shot.X_CT, shot.visible});
    if (shot.robot) writer.addFlange(shot.frame.exposed_at, shot.robot->q_rad, shot.robot->X_BF);
  }
}

void simulate(const Request& request, Context& context) {
  const auto scene = orRefuse(simulation::readScene(request.scene, resourceFolder()));
  auto player = orRefuse(simulation::ScenePlayer::make(scene, resourceFolder()));
  auto writer = devices::RecordingWriter::create(request.out, player.rig());
  if (!writer) throw InputRefused(writer.error());
  orFail(tracking::writeTarget(writer->stagingFolder() / "target.yaml", targetOf(scene, player)));
  writeMeta(writer->stagingFolder() / "meta.yaml", scene);
  shootAll(scene, player, *writer);
  orFail(writer->finish());
  context.result = {{"frames", scene.frames}, {"folder", request.out.string()}};
  if (!context.json) std::cout << scene.frames << " frames in " << request.out.string() << "\n";
}

}  // namespace

void addSimulate(CLI::App& app, Context& context) {
  auto request = std::make_shared<Request>();
  CLI::App* command = addCommand(app, context, "simulate", "Make a stereo recording with truth from a scene",
                                 "mirrorarm-cli simulate resources/scenes/paper_cuboid.yaml --out recording");
  command->add_option("scene", request->scene, "Scene file (docs/scene-format.md)")->required();
  command->add_option("--out", request->out, "Folder to make; must not hold anything")->required();
  command->callback([request, &context] { simulate(*request, context); });
}

}  // namespace mirrorarm::cli
