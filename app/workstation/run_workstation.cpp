#include "app/workstation/run_workstation.h"

#include <iostream>

#include <QApplication>
#include <QStyleFactory>

#include "app/workstation/calibration_room.h"
#include "app/workstation/session_room.h"
#include "core/common/resources.h"
#include "core/therapy/exercise.h"
#include "ui/language/language.h"
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

/// One room after another: never two at a time, for they share the devices.
int runRooms(WorkstationOrder order, const ui::Themes& themes) {
  auto room = order.calibrate ? Room::kCalibration : Room::kSession;
  while (room != Room::kNone) {
    const auto left = room == Room::kSession ? runSession(order, themes) : runCalibration(order, themes);
    if (!left) return tell(left.error().exit_code, left.error().reason);
    if (left->exit_code != kDone) return left->exit_code;
    room = left->next;
    order.dark = left->dark;
  }
  return kDone;
}

}  // namespace

int runWorkstation(const WorkstationOrder& order, int argc, char** argv) {
  if (!therapy::exerciseOf(order.exercise))
    return tell(kWrongUse, "--exercise: there is none called '" + order.exercise + "'");
  if (!hasDisplay()) return tell(kFailed, "there is no display; --report and mirrorarm-cli need none");
  ui::SceneView::prepareSurface();
  QApplication::setApplicationName(QStringLiteral("mirrorarm"));
  const QApplication application(argc, argv);
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  if (!ui::useLanguage(QString::fromStdString(order.language)))
    return tell(kWrongUse, "--language: there is no translation to " + order.language);
  const auto themes = ui::Themes::read(resourceFolder() / "style");
  if (!themes) return tell(kFailed, describe(themes.error()));
  return runRooms(order, *themes);
}

}  // namespace mirrorarm::workstation
