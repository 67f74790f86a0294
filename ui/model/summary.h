#pragma once

#include <QString>
#include <QVector>

#include "core/therapy/session_measures.h"

namespace mirrorarm::ui {

/// One line of a session's summary, ready to be read.
struct SummaryLine {
  QString name;
  QString value;
  bool operator==(const SummaryLine&) const = default;
};

/// What a session came to beside its duration and repetitions, the most telling first; the report tells the
/// rest.
[[nodiscard]] QVector<SummaryLine> summaryOf(const therapy::SessionMeasures& measures);

}  // namespace mirrorarm::ui
