#pragma once

#include <QObject>
#include <QTimer>

#include "core/common/time.h"
#include "core/station/station_port.h"

namespace mirrorarm::ui {

/// The screen's own beat: about 30 times a second it takes one snapshot and hands it round, on the screen's
/// thread. A slow screen takes fewer; nothing queues up.
class LiveFeed : public QObject {
  Q_OBJECT
 public:
  /// `port` outlives the feed.
  explicit LiveFeed(station::StationPort& port, QObject* parent = nullptr);

  void start();
  /// One beat at once, besides the timer's.
  void take();

 signals:
  void taken(const mirrorarm::station::Snapshot& snapshot, mirrorarm::TimePoint now);

 private:
  station::StationPort& port_;
  QTimer timer_;
};

}  // namespace mirrorarm::ui
