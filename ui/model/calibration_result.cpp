#include "ui/model/calibration_result.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/model/calibration_words.h"
#include "ui/model/result_rows.h"

namespace mirrorarm::ui {
namespace {

struct Verdicts {
  Q_DECLARE_TR_FUNCTIONS(CalibrationResult)
};

Light worstOf(const QVector<ResultRow>& rows) {
  const auto worst = std::ranges::max_element(rows, {}, &ResultRow::light);
  return worst == rows.end() ? Light::kOff : worst->light;
}

QString verdictOf(Light light) {
  switch (light) {
    case Light::kOff:
    case Light::kGood:
      return Verdicts::tr("Every figure is within its limit.");
    case Light::kWaiting:
      return Verdicts::tr("Usable, but a figure is beyond its limit: more views would make it better.");
    case Light::kBad:
      return Verdicts::tr("Not good enough: go back, remove the views that stand out and add others.");
  }
  return {};
}

}  // namespace

CalibrationResult resultOf(const station::CalibrationOutcome& outcome) {
  CalibrationResult result;
  result.rows = std::visit([](const auto& one) { return rowsOf(one); }, outcome);
  result.light = worstOf(result.rows);
  const auto* drift = std::get_if<station::DriftOutcome>(&outcome);
  result.verdict =
      drift != nullptr ? words(drift->findings.verdict) + QLatin1Char('.') : verdictOf(result.light);
  return result;
}

}  // namespace mirrorarm::ui
