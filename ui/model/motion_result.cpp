#include <numbers>

#include <QCoreApplication>

#include "ui/model/calibration_words.h"
#include "ui/model/result_rows.h"

namespace mirrorarm::ui {
namespace {

struct MotionResult {
  Q_DECLARE_TR_FUNCTIONS(MotionResult)
};

using Unit = Quantity::Unit;

constexpr double kHandEye_mm = 0.5;
constexpr double kHandEye_deg = 0.1;
constexpr double kHandEyeSigma_mm = 0.2;
constexpr double kClockSigma_ms = 2.0;
constexpr double kGoodCorrelation = 0.95;
constexpr double kDoubtfulCorrelation = 0.8;

Quantity degrees(double rad, int decimals) {
  return {rad * 180.0 / std::numbers::pi, Unit::kDegree, decimals};
}

Quantity millimetres(double m, int decimals) { return {1e3 * m, Unit::kMillimetre, decimals}; }

/// The list of views marks which.
QString leftOut(const calibration::HandEyeSolution& result) {
  if (result.outliers.empty()) return MotionResult::tr("none");
  return MotionResult::tr("%1 of %2").arg(result.outliers.size()).arg(result.stations.size());
}

Light correlationLight(double correlation) {
  if (correlation >= kGoodCorrelation) return Light::kGood;
  return correlation >= kDoubtfulCorrelation ? Light::kWaiting : Light::kBad;
}

void addGrid(const calibration::DriftFindings::Grid& grid, const calibration::DriftLimits& limits,
             ResultRows& rows) {
  rows.addHeading(MotionResult::tr("Over %1 stations of the robot").arg(grid.stations));
  const std::array<QString, 3> axes{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (int axis = 0; axis < 3; ++axis)
    rows.addLimited(
        MotionResult::tr("Place of the board along %1, spread").arg(axes[static_cast<std::size_t>(axis)]),
        {grid.std_mm[axis], Unit::kMillimetre, 3}, limits.grid_std_mm);
  rows.addLimited(MotionResult::tr("Steps of the cameras against the robot's"),
                  {grid.scale_percent, Unit::kPercent, 3}, limits.grid_scale_percent);
}

}  // namespace

QVector<ResultRow> rowsOf(const station::HandEyeOutcome& outcome) {
  const auto& result = outcome.result;
  ResultRows rows;
  rows.addHeading(MotionResult::tr("How far the board strays over %1 views")
                      .arg(result.stations.size() - result.outliers.size()));
  rows.addLimited(MotionResult::tr("Position"), millimetres(result.rms_m, 3), kHandEye_mm);
  rows.addLimited(MotionResult::tr("Orientation"), degrees(result.rms_rad, 3), kHandEye_deg);
  rows.add(MotionResult::tr("Views left out"), leftOut(result),
           result.outliers.empty() ? Light::kGood : Light::kWaiting);
  rows.addHeading(MotionResult::tr("Camera on the flange"));
  if (result.sigma_m)
    rows.addLimited(MotionResult::tr("Standard deviation of its position"), millimetres(*result.sigma_m, 3),
                    kHandEyeSigma_mm);
  const Eigen::Vector3d place_mm = 1e3 * result.X_PC.translation();
  rows.add(MotionResult::tr("Its position"), MotionResult::tr("%1 / %2 / %3 mm")
                                                 .arg(place_mm.x(), 0, 'f', 2)
                                                 .arg(place_mm.y(), 0, 'f', 2)
                                                 .arg(place_mm.z(), 0, 'f', 2));
  if (!outcome.shift_mm && !outcome.turn_deg) return rows.rows();
  rows.addHeading(MotionResult::tr("Against the calibration in force"));
  if (outcome.shift_mm)
    rows.add(MotionResult::tr("Shifted by"), Quantity{*outcome.shift_mm, Unit::kMillimetre, 2});
  if (outcome.turn_deg)
    rows.add(MotionResult::tr("Turned by"), Quantity{*outcome.turn_deg, Unit::kDegree, 3});
  return rows.rows();
}

QVector<ResultRow> rowsOf(const station::ClockOutcome& outcome) {
  const auto& result = outcome.result;
  ResultRows rows;
  rows.addHeading(MotionResult::tr("Clock of the cameras against the robot's"));
  rows.add(MotionResult::tr("Offset"), Quantity{1e3 * result.offset_s, Unit::kMillisecond, 2});
  rows.addLimited(MotionResult::tr("Its standard deviation"), {1e3 * result.sigma_s, Unit::kMillisecond, 2},
                  kClockSigma_ms);
  rows.add(MotionResult::tr("Both movements agree to"),
           Quantity{100.0 * result.correlation, Unit::kPercent, 1}.text(),
           correlationLight(result.correlation));
  rows.addHeading(MotionResult::tr("Left over along the way, median"));
  rows.add(MotionResult::tr("Position"), millimetres(result.median_m, 2));
  rows.add(MotionResult::tr("Orientation"), degrees(result.median_rad, 2));
  return rows.rows();
}

QVector<ResultRow> rowsOf(const station::DriftOutcome& outcome) {
  const auto& findings = outcome.findings;
  const calibration::DriftLimits limits;
  ResultRows rows;
  rows.addHeading(MotionResult::tr("On %1 points").arg(findings.points));
  rows.addLimited(MotionResult::tr("Distance from the epipolar line"),
                  {findings.epipolar_px, Unit::kPixel, 3}, limits.epipolar_px);
  rows.addLimited(MotionResult::tr("Lengths on the board, mean error"),
                  {findings.length_percent, Unit::kPercent, 3}, limits.length_percent);
  rows.add(MotionResult::tr("Reprojection"), Quantity{findings.reprojection_px, Unit::kPixel, 3});
  if (findings.grid) addGrid(*findings.grid, limits, rows);
  return rows.rows();
}

}  // namespace mirrorarm::ui
