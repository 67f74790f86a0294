#include "core/experiments/occlusion.h"

namespace mirrorarm::experiments {
namespace {

constexpr int kShares = 6;
constexpr double kShareStep = 0.1;

}  // namespace

Expected<std::vector<OcclusionRow>, std::string> measureOcclusion(const std::filesystem::path& resources) {
  auto scene = simulation::readScene(resources / "scenes" / "paper_cuboid.yaml", resources);
  if (!scene) return unexpected(describe(scene.error()));
  Expected<tracking::Target, tracking::TeachingError> ours = unexpected(tracking::TeachingError::kNoFrames);
  Expected<tracking::Target, tracking::TeachingError> paper = ours;
  std::vector<OcclusionRow> rows;
  for (int i = 0; i < kShares; ++i) {
    scene->covered_share = i * kShareStep;
    const auto played = play(*scene, resources);
    if (!played) return unexpected(describe(played.error()));
    if (i == 0) {
      ours = teachFrom(*played, Approach{}.centres);
      paper = teachFrom(*played, kPaperApproach.centres);
    }
    if (!ours || !paper) return unexpected(std::string("the target could not be taught"));
    rows.push_back({scene->covered_share, statisticsOf(track(*played, *ours, {}, true)),
                    statisticsOf(track(*played, *paper, kPaperApproach, true))});
  }
  return rows;
}

}  // namespace mirrorarm::experiments
