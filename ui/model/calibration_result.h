#pragma once

#include <QString>
#include <QVector>

#include "core/station/calibration_snapshot.h"
#include "ui/model/light.h"

namespace mirrorarm::ui {

/// One figure of a result. A heading has a figure only.
struct ResultRow {
  bool is_heading = false;
  Light light = Light::kOff;  ///< off: for information, it has no limit
  QString figure;
  QString value;
  QString in_force;  ///< the same of the calibration in force; may be empty
  QString limit;     ///< largest value that is good
  bool operator==(const ResultRow&) const = default;
};

/// What solving gave, as the engineer judges it.
struct CalibrationResult {
  Light light = Light::kOff;  ///< the worst of all rows
  QString verdict;            ///< one sentence
  QVector<ResultRow> rows;
  bool operator==(const CalibrationResult&) const = default;
};

/// Green to the limit, amber to twice the limit, red beyond: amber is what the drift check calls doubtful.
[[nodiscard]] CalibrationResult resultOf(const station::CalibrationOutcome& outcome);

}  // namespace mirrorarm::ui
