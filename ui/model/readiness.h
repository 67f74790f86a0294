#pragma once

#include <QString>
#include <QVector>

#include "core/common/time.h"
#include "core/station/snapshot.h"
#include "ui/model/workplace.h"

namespace mirrorarm::ui {

/// One line of the check before a session.
struct Check {
  QString text;
  bool passed = false;
  bool operator==(const Check&) const = default;
};

/// Whether cameras, robot, calibration and markers are ready: a pure function.
[[nodiscard]] QVector<Check> readinessOf(const station::Snapshot& snapshot, const Workplace& workplace,
                                         TimePoint now);

}  // namespace mirrorarm::ui
