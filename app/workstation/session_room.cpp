#include "app/workstation/session_room.h"

#include "app/workstation/room_window.h"
#include "app/workstation/session_reports.h"
#include "app/workstation/session_tour.h"
#include "core/calibration/validity.h"
#include "core/common/resources.h"
#include "core/common/time_source.h"
#include "core/robot/motion_limits.h"
#include "core/station/bench_equipment.h"
#include "core/station/calibrated_equipment.h"
#include "core/station/station.h"
#include "ui/panels/main_window.h"

namespace mirrorarm::workstation {
namespace {

simulation::BenchSettings benchSettings(const WorkstationOrder& order) {
  simulation::BenchSettings settings;
  settings.resources = resourceFolder();
  settings.motion = order.motion;
  settings.legs = station::legsOf(therapy::exerciseOf(order.exercise).value());
  settings.seed = order.seed;
  settings.robot_gives_way = order.help_as_needed;
  return settings;
}

robot::GivesWay givesWay(const WorkstationOrder& order) {
  return order.help_as_needed ? robot::GivesWay::kInJoints : robot::GivesWay::kNot;
}

station::StationSettings stationSettings(const WorkstationOrder& order) {
  const auto store = storeOf(order);
  station::StationSettings settings;
  settings.store_file = store;
  settings.black_box_folder = store.parent_path();
  settings.exercise = order.motion.empty() ? order.exercise : order.motion.filename().string();
  settings.planner.seed = order.seed;
  settings.supervisor.enabling_needed = order.enabling_key;
  settings.assist.help.adapts = order.help_as_needed;
  return settings;
}

ui::Workplace workplaceOf(const station::Equipment& equipment, const station::StationSettings& settings) {
  ui::Workplace workplace;
  workplace.rig = equipment.rig;
  workplace.arm = equipment.arm;
  workplace.limits = robot::limitsOf(settings.limits_profile, equipment.arm).value();
  workplace.attached = equipment.attached;
  workplace.X_FC = equipment.X_FC;
  workplace.X_FE = equipment.X_FE;
  workplace.simulated = equipment.simulated;
  return workplace;
}

/// The simulated patient moves while markers are taught and from the start of training to its end: in a pause
/// too, so that an arm that left the view comes back into it.
void instructPatient(ui::SessionPresenter& session, simulation::Bench& bench) {
  QObject::connect(&session, &ui::SessionPresenter::stateChanged, [&bench](const ui::SessionState& state) {
    using therapy::Phase;
    bench.setPatientMoving(state.phase == Phase::kTeaching || state.phase == Phase::kTraining ||
                           state.phase == Phase::kPaused);
  });
}

}  // namespace

Expected<Leaving, NotOpened> runSession(const WorkstationOrder& order, const ui::Themes& themes) {
  const auto in_force = calibration::CalibrationFolder(calibrationsOf(order)).read();
  if (!in_force) return unexpected(NotOpened{describe(in_force.error())});
  const SteadyTime time;
  auto robot = app::openBenchRobot(order.robot, givesWay(order));
  if (!robot) return unexpected(NotOpened{robot.error(), kFailed});
  const auto bench = simulation::Bench::make(benchSettings(order), time, std::move(*robot));
  if (!bench) return unexpected(NotOpened{describe(bench.error())});

  const auto store = storeOf(order);
  std::filesystem::create_directories(store.parent_path().empty() ? "." : store.parent_path());
  const auto validity = calibration::validityOf(*in_force, std::chrono::system_clock::now());
  const auto equipment = station::calibrated(station::equipmentOf(**bench), *in_force, validity);
  const auto settings = stationSettings(order);
  auto workplace = workplaceOf(equipment, settings);
  // The simulated bench knows its calibrations exactly until one is in force.
  if (!equipment.simulated || !in_force->empty()) workplace.calibrations = validity;
  station::Station station(equipment, settings);
  ui::MainWindow window(station, std::move(workplace), themes, sessionReportsOf(store));
  instructPatient(window.session(), **bench);
  SessionTour tour(window, order.tour);
  return show(window, tour, &ui::MainWindow::calibrationWanted, Room::kCalibration, order);
}

}  // namespace mirrorarm::workstation
