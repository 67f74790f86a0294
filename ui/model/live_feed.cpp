#include "ui/model/live_feed.h"

#include <chrono>

namespace mirrorarm::ui {

LiveFeed::LiveFeed(station::StationPort& port, QObject* parent) : QObject(parent), port_(port) {
  timer_.setInterval(std::chrono::milliseconds(33));
  connect(&timer_, &QTimer::timeout, this, &LiveFeed::take);
}

void LiveFeed::start() { timer_.start(); }

void LiveFeed::take() { emit taken(port_.snapshot(), Clock::now()); }

}  // namespace mirrorarm::ui
