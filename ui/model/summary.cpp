#include "ui/model/summary.h"

#include <optional>

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

struct Summary {
  Q_DECLARE_TR_FUNCTIONS(Summary)
};

QString number(double value, int decimals, const QString& unit) {
  return QStringLiteral("%1 %2").arg(value, 0, 'f', decimals).arg(unit);
}

QString percent(double share) { return number(100.0 * share, 0, QStringLiteral("%")); }

}  // namespace

QVector<SummaryLine> summaryOf(const therapy::SessionMeasures& measures) {
  const QString mm = QStringLiteral("mm");
  QVector<SummaryLine> lines{
      {Summary::tr("Range of the healthy arm"), number(measures.range_mm, 0, mm)},
      {Summary::tr("Delay of the robot"), number(measures.lag_ms, 0, QStringLiteral("ms"))},
      {Summary::tr("Error without delay"), number(measures.shape_error_mm, 1, mm)},
      {Summary::tr("Error with delay"), number(measures.felt_error_mm, 1, mm)}};
  const auto add = [&lines](const QString& name, const std::optional<double>& share) {
    if (share) lines.push_back({name, percent(*share)});
  };
  add(Summary::tr("Largest force, of its limit"), measures.force_share);
  add(Summary::tr("Mean help"), measures.help_level);
  add(Summary::tr("Time of adapting help"), measures.help_adapting_share);
  return lines;
}

}  // namespace mirrorarm::ui
