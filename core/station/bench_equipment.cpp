#include "core/station/bench_equipment.h"

#include "core/geometry/rigid_fit.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::station {

Equipment equipmentOf(simulation::Bench& bench) {
  Equipment equipment;
  equipment.cameras = &bench.cameras();
  equipment.robot = &bench.robot();
  equipment.rig = bench.rig();
  equipment.arm = bench.arm();
  equipment.attached = bench.attached();
  equipment.obstacles = bench.surroundings();
  equipment.X_FC = bench.X_FC();
  equipment.X_FE = bench.X_FE();
  equipment.simulated = true;
  return equipment;
}

simulation::Plate plateOf(const calibration::Board& board) {
  const auto points_M = calibration::boardPoints(board);
  const auto diameters_m = calibration::discDiameters_m(board);
  simulation::Plate plate;
  for (std::size_t i = 0; i < points_M.size(); ++i)
    plate.patches_M.push_back(simulation::patchOf({points_M[i], -Eigen::Vector3d::UnitZ(), diameters_m[i]}));
  plate.X_BM = simulation::bench_layout::plateX_BP() * Eigen::Translation3d(-centroid(points_M));
  return plate;
}

std::vector<simulation::MinimumJerkLeg> legsOf(const therapy::Exercise& exercise) {
  std::vector<simulation::MinimumJerkLeg> legs;
  for (const auto& leg : exercise.legs)
    legs.push_back({leg.displacement_m, leg.forearm_turn_rad, leg.duration_s, leg.rest_s});
  return legs;
}

}  // namespace mirrorarm::station
