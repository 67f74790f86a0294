#include "app/workstation/run_workstation.h"

#include <iostream>
#include <optional>

#include <QApplication>
#include <QStandardPaths>
#include <QStyleFactory>

#include "app/workstation/exit_code.h"
#include "app/workstation/session_reports.h"
#include "app/workstation/tour.h"
#include "core/common/resources.h"
#include "core/common/time_source.h"
#include "core/robot/motion_limits.h"
#include "core/station/bench_equipment.h"
#include "core/station/station.h"
#include "ui/language/language.h"
#include "ui/panels/main_window.h"
#include "ui/views/scene_view.h"

namespace mirrorarm::workstation {
namespace {

int tell(ExitCode code, const std::string& reason) {
  std::cerr << "mirrorarm: " << reason << "\n";
  return code;
}

/// Qt would abort the program where there is none.
bool hasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

std::filesystem::path storeOf(const WorkstationOrder& order) {
  if (!order.store.empty()) return order.store;
  if (!order.tour.empty()) return order.tour / "store.sqlite";
  return std::filesystem::path(
             QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString()) /
         "store.sqlite";
}

std::optional<simulation::BenchSettings> benchSettings(const WorkstationOrder& order) {
  const auto exercise = therapy::exerciseOf(order.exercise);
  if (!exercise) return std::nullopt;
  simulation::BenchSettings settings;
  settings.resources = resourceFolder();
  settings.motion = order.motion;
  settings.legs = station::legsOf(*exercise);
  settings.seed = order.seed;
  return settings;
}

station::StationSettings stationSettings(const WorkstationOrder& order, const std::filesystem::path& store) {
  station::StationSettings settings;
  settings.store_file = store;
  settings.black_box_folder = store.parent_path();
  settings.exercise = order.motion.empty() ? order.exercise : order.motion.filename().string();
  settings.planner.seed = order.seed;
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

int runWindow(ui::MainWindow& window, const WorkstationOrder& order) {
  window.resize(order.size_px[0], order.size_px[1]);
  window.setDark(order.dark);
  window.show();
  window.start();
  if (order.tour.empty()) return QApplication::exec();
  Tour tour(window, order.tour);
  QObject::connect(&tour, &Tour::finished, qApp, &QApplication::exit, Qt::QueuedConnection);
  tour.start();
  return QApplication::exec();
}

}  // namespace

int runWorkstation(const WorkstationOrder& order, int argc, char** argv) {
  const auto settings = benchSettings(order);
  if (!settings) return tell(kWrongUse, "--exercise: there is none called '" + order.exercise + "'");
  if (!hasDisplay()) return tell(kFailed, "there is no display; --report and mirrorarm-cli need none");
  ui::SceneView::prepareSurface();
  QApplication::setApplicationName(QStringLiteral("mirrorarm"));
  QApplication application(argc, argv);
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  if (!ui::useLanguage(QString::fromStdString(order.language)))
    return tell(kWrongUse, "--language: there is no translation to " + order.language);
  auto themes = ui::Themes::read(resourceFolder() / "style");
  if (!themes) return tell(kFailed, describe(themes.error()));
  const SteadyTime time;
  const auto bench = simulation::Bench::make(*settings, time);
  if (!bench) return tell(kWrongUse, describe(bench.error()));

  const auto store = storeOf(order);
  std::filesystem::create_directories(store.parent_path().empty() ? "." : store.parent_path());
  const auto equipment = station::equipmentOf(**bench);
  const auto station_settings = stationSettings(order, store);
  station::Station station(equipment, station_settings);
  ui::MainWindow window(station, workplaceOf(equipment, station_settings), std::move(*themes),
                        sessionReportsOf(store));
  instructPatient(window.session(), **bench);
  return runWindow(window, order);
}

}  // namespace mirrorarm::workstation
