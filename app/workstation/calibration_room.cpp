#include "app/workstation/calibration_room.h"

#include <QApplication>

#include "app/workstation/calibration_tour.h"
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
  return settings;
}

/// Without one in force the rig is what the cameras are built to.
ui::InForceView inForceIn(const calibration::CalibrationFolder& folder, const camera::StereoRig& built) {
  const auto in_force = folder.read().value_or(calibration::InForce{});
  const auto validity = calibration::validityOf(in_force, std::chrono::system_clock::now());
  return {ui::standingLines(validity), in_force.rig ? *in_force.rig : built};
}

Leaving show(ui::CalibrationWindow& window, const WorkstationOrder& order) {
  Leaving leaving;
  QObject::connect(&window, &ui::CalibrationWindow::sessionWanted, &window, [&leaving] {
    leaving.next = Room::kSession;
    QApplication::quit();
  });
  if (order.calibrate) window.presenter().choose(*order.calibrate);
  window.resize(order.size_px[0], order.size_px[1]);
  window.setDark(order.dark);
  window.show();
  window.start();
  CalibrationTour tour(window, order.tour);
  if (!order.tour.empty()) {
    QObject::connect(&tour, &Tour::finished, qApp, &QApplication::exit, Qt::QueuedConnection);
    tour.start();
  }
  leaving.exit_code = QApplication::exec();
  leaving.dark = window.isDark();
  return leaving;
}

}  // namespace

Expected<Leaving, std::string> runCalibration(const WorkstationOrder& order, const ui::Themes& themes) {
  const calibration::CalibrationFolder folder(calibrationsOf(order));
  if (const auto in_force = folder.read(); !in_force) return unexpected(describe(in_force.error()));
  const SteadyTime time;
  const auto bench = simulation::Bench::make(benchSettings(order), time);
  if (!bench) return unexpected(describe(bench.error()));
  const auto equipment = station::equipmentOf(**bench);
  station::CalibrationStation station(equipment, stationSettings(order));
  ui::CalibrationWindow window(station, {kPlate, equipment.simulated}, themes,
                               [&] { return inForceIn(folder, equipment.rig); });
  return show(window, order);
}

}  // namespace mirrorarm::workstation
