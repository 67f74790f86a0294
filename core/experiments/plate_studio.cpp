#include "core/experiments/plate_studio.h"

#include "core/calibration/board_finder.h"
#include "core/simulation/counter_random.h"

namespace mirrorarm::experiments {
namespace {

/// M's z axis points away from the viewer: the discs look against it.
std::vector<simulation::Patch> discsOf(const calibration::Board& plate) {
  const auto points = boardPoints(plate);
  const auto diameters = discDiameters_m(plate);
  std::vector<simulation::Patch> discs;
  for (std::size_t i = 0; i < points.size(); ++i)
    discs.push_back(simulation::patchOf({points[i], -Eigen::Vector3d::UnitZ(), diameters[i]}));
  return discs;
}

}  // namespace

PlateStudio::PlateStudio(const camera::StereoRig& rig, const calibration::Board& plate, std::uint64_t seed)
    : plate_(plate), discs_M_(discsOf(plate)), renderer_(rig, {}, {}), seed_(seed) {}

std::optional<calibration::BoardView> PlateStudio::take(const RigidTransform& X_CM, const std::string& name) {
  simulation::StereoRenderer::Instant discs_C;
  for (const auto& disc_M : discs_M_) discs_C.push_back(transformed(X_CM, disc_M));
  const auto [left, right] = renderer_.render({&discs_C, 1}, simulation::counterRandom(seed_, taken_++));
  const auto in_left = calibration::findBoard(left.view(), plate_);
  const auto in_right = calibration::findBoard(right.view(), plate_);
  if (!in_left || !in_right) return std::nullopt;
  return calibration::BoardView{name, {*in_left, *in_right}};
}

}  // namespace mirrorarm::experiments
