#include "app/workstation/calibration_room.h"

#include "app/workstation/calibration_tour.h"
#include "app/workstation/room_window.h"
#include "core/calibration/validity.h"
#include "core/common/resources.h"
#include "core/common/time_source.h"
#include "core/station/bench_equipment.h"
#include "core/station/calibration_station.h"
#include "ui/wizards/calibration_window.h"

namespace mirrorarm::workstation {
namespace {

/// The plate of retroreflective dots that stands before the simulated cameras.
const calibration::Board kPlate{calibration::BoardKind::kDotPlate, 9, 7, 0.03};

simulation::BenchSettings benchSettings(const WorkstationOrder& order) {
  simulation::BenchSettings settings;
  settings.resources = resourceFolder();
  settings.plate = station::plateOf(kPlate);
  settings.seed = order.seed;
  return settings;
}

station::CalibrationSettings stationSettings(const WorkstationOrder& order) {
  station::CalibrationSettings settings;
  settings.folder = calibrationsOf(order);
  settings.black_box_folder = storeOf(order).parent_path();
  settings.planner.seed = order.seed;
  settings.supervisor.enabling_needed = order.enabling_key;
  return settings;
}

/// Without one in force the rig is what the cameras are built to.
ui::InForceView inForceIn(const calibration::CalibrationFolder& folder, const camera::StereoRig& built) {
  const auto in_force = folder.read().value_or(calibration::InForce{});
  const auto validity = calibration::validityOf(in_force, std::chrono::system_clock::now());
  return {ui::standingLines(validity), in_force.rig ? *in_force.rig : built};
}

}  // namespace

Expected<Leaving, NotOpened> runCalibration(const WorkstationOrder& order, const ui::Themes& themes) {
  const calibration::CalibrationFolder folder(calibrationsOf(order));
  if (const auto in_force = folder.read(); !in_force)
    return unexpected(NotOpened{describe(in_force.error())});
  const SteadyTime time;
  auto robot = app::openBenchRobot(order.robot);
  if (!robot) return unexpected(NotOpened{robot.error(), kFailed});
  const auto bench = simulation::Bench::make(benchSettings(order), time, std::move(*robot));
  if (!bench) return unexpected(NotOpened{describe(bench.error())});
  const auto equipment = station::equipmentOf(**bench);
  station::CalibrationStation station(equipment, stationSettings(order));
  ui::CalibrationWindow window(station, {kPlate, equipment.simulated}, themes,
                               [&] { return inForceIn(folder, equipment.rig); });
  if (order.calibrate) window.presenter().choose(*order.calibrate);
  CalibrationTour tour(window, order.tour);
  return show(window, tour, &ui::CalibrationWindow::sessionWanted, Room::kSession, order);
}

}  // namespace mirrorarm::workstation
