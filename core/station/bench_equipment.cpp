#include "core/station/bench_equipment.h"

namespace mirrorarm::station {

Equipment equipmentOf(simulation::Bench& bench) {
  Equipment equipment;
  equipment.cameras = &bench.cameras();
  equipment.robot = &bench.robot();
  equipment.rig = bench.rig();
  equipment.arm = bench.arm();
  equipment.attached = bench.attached();
  equipment.X_FC = bench.X_FC();
  equipment.X_FE = bench.X_FE();
  equipment.simulated = true;
  return equipment;
}

std::vector<simulation::MinimumJerkLeg> legsOf(const therapy::Exercise& exercise) {
  std::vector<simulation::MinimumJerkLeg> legs;
  for (const auto& leg : exercise.legs)
    legs.push_back({leg.displacement_m, leg.forearm_turn_rad, leg.duration_s, leg.rest_s});
  return legs;
}

}  // namespace mirrorarm::station
