#include "ui/model/result_rows.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

struct Quantities {
  Q_DECLARE_TR_FUNCTIONS(Quantities)
};

}  // namespace

QString Quantity::text() const {
  const QString number = QString::number(value, 'f', decimals);
  switch (unit) {
    case Unit::kPixel:
      return Quantities::tr("%1 px").arg(number);
    case Unit::kMillimetre:
      return Quantities::tr("%1 mm").arg(number);
    case Unit::kDegree:
      return Quantities::tr("%1°").arg(number);
    case Unit::kPercent:
      return Quantities::tr("%1 %").arg(number);
    case Unit::kMillisecond:
      return Quantities::tr("%1 ms").arg(number);
  }
  return {};
}

void ResultRows::addHeading(const QString& text) { rows_.push_back({true, Light::kOff, text, {}, {}, {}}); }

void ResultRows::add(const QString& figure, const QString& value, Light light) {
  rows_.push_back({false, light, figure, value, {}, {}});
}

void ResultRows::add(const QString& figure, const Quantity& quantity, const QString& in_force) {
  rows_.push_back({false, Light::kOff, figure, quantity.text(), in_force, {}});
}

void ResultRows::addLimited(const QString& figure, const Quantity& quantity, double limit,
                            const QString& in_force) {
  const double magnitude = std::abs(quantity.value);
  const Light light = magnitude <= limit       ? Light::kGood
                      : magnitude <= 2 * limit ? Light::kWaiting
                                               : Light::kBad;  // also what is no number
  const Quantity largest{limit, quantity.unit, quantity.decimals};
  rows_.push_back({false, light, figure, quantity.text(), in_force, QStringLiteral("≤ ") + largest.text()});
}

}  // namespace mirrorarm::ui
