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

QString percent(double share, int decimals = 0) {
  return number(100.0 * share, decimals, QStringLiteral("%"));
}

void addForceAndHelp(const therapy::SessionMeasures& measures, QVector<SummaryLine>& lines) {
  if (measures.force_share)
    lines.push_back(
        {Summary::tr("Largest force"), Summary::tr("%1 of limit").arg(percent(*measures.force_share))});
  if (measures.help_level) lines.push_back({Summary::tr("Mean help"), percent(*measures.help_level)});
  if (measures.help_adapting_share)
    lines.push_back(
        {Summary::tr("Help adapted"), Summary::tr("%1 of time").arg(percent(*measures.help_adapting_share))});
}

}  // namespace

QVector<SummaryLine> summaryOf(const therapy::SessionMeasures& measures) {
  const QString mm = QStringLiteral("mm");
  QVector<SummaryLine> lines{
      {Summary::tr("Range of the healthy arm"), number(measures.range_mm, 0, mm)},
      {Summary::tr("Delay of the robot"), number(measures.lag_ms, 0, QStringLiteral("ms"))},
      {Summary::tr("Error without delay"), number(measures.shape_error_mm, 1, mm)},
      {Summary::tr("Error with delay"), number(measures.felt_error_mm, 1, mm)},
      {Summary::tr("Frames tracked"), percent(measures.tracked_share, 1)}};
  addForceAndHelp(measures, lines);
  return lines;
}

}  // namespace mirrorarm::ui
