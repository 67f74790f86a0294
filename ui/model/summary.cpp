#include "ui/model/summary.h"

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

struct Summary {
  Q_DECLARE_TR_FUNCTIONS(Summary)
};

QString number(double value, int decimals, const QString& unit) {
  return QStringLiteral("%1 %2").arg(value, 0, 'f', decimals).arg(unit);
}

}  // namespace

QVector<SummaryLine> summaryOf(const therapy::SessionMeasures& measures) {
  const QString mm = QStringLiteral("mm");
  return {{Summary::tr("Range of the healthy arm"), number(measures.range_mm, 0, mm)},
          {Summary::tr("Delay of the robot"), number(measures.lag_ms, 0, QStringLiteral("ms"))},
          {Summary::tr("Error without delay"), number(measures.shape_error_mm, 1, mm)},
          {Summary::tr("Error with delay"), number(measures.felt_error_mm, 1, mm)},
          {Summary::tr("Frames tracked"), number(measures.tracked_share * 100.0, 1, QStringLiteral("%"))}};
}

}  // namespace mirrorarm::ui
