#pragma once

#include <QApplication>

#include "app/workstation/leaving.h"
#include "app/workstation/tour.h"
#include "app/workstation/workstation_order.h"

namespace mirrorarm::workstation {

/// Shows a room's window until it is closed, or `wanted`, a signal of it, asks for the room `next`. Where a
/// tour was ordered, `tour` walks through it and ends the program.
template <class Window, class Wanted>
Leaving show(Window& window, Tour& tour, Wanted wanted, Room next, const WorkstationOrder& order) {
  Leaving leaving;
  QObject::connect(&window, wanted, &window, [&leaving, next] {
    leaving.next = next;
    QApplication::quit();
  });
  window.resize(order.size_px[0], order.size_px[1]);
  window.setDark(order.dark);
  window.show();
  window.start();
  if (!order.tour.empty()) {
    QObject::connect(&tour, &Tour::finished, qApp, &QApplication::exit, Qt::QueuedConnection);
    tour.start();
  }
  leaving.exit_code = QApplication::exec();
  leaving.dark = window.isDark();
  return leaving;
}

}  // namespace mirrorarm::workstation
