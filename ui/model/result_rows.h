#pragma once

#include "ui/model/calibration_result.h"

namespace mirrorarm::ui {

/// A number with its unit, as people read it.
struct Quantity {
  enum class Unit { kPixel, kMillimetre, kDegree, kPercent, kMillisecond };
  double value = 0.0;
  Unit unit = Unit::kPixel;
  int decimals = 2;
  [[nodiscard]] QString text() const;
};

/// The rows of a result one after another.
class ResultRows {
 public:
  void addHeading(const QString& text);
  /// For information.
  void add(const QString& figure, const QString& value, Light light = Light::kOff);
  void add(const QString& figure, const Quantity& quantity, const QString& in_force = {});
  /// With the largest magnitude that is good.
  void addLimited(const QString& figure, const Quantity& quantity, double limit,
                  const QString& in_force = {});
  [[nodiscard]] const QVector<ResultRow>& rows() const { return rows_; }

 private:
  QVector<ResultRow> rows_;
};

// The rows of each kind of outcome.
[[nodiscard]] QVector<ResultRow> rowsOf(const station::StereoOutcome& outcome);
[[nodiscard]] QVector<ResultRow> rowsOf(const station::HandEyeOutcome& outcome);
[[nodiscard]] QVector<ResultRow> rowsOf(const station::ClockOutcome& outcome);
[[nodiscard]] QVector<ResultRow> rowsOf(const station::DriftOutcome& outcome);

}  // namespace mirrorarm::ui
