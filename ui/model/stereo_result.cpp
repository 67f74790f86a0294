#include <algorithm>
#include <cmath>
#include <numbers>

#include <QCoreApplication>
#include <QStringList>

#include "ui/model/calibration_words.h"
#include "ui/model/result_rows.h"

namespace mirrorarm::ui {
namespace {

struct StereoResult {
  Q_DECLARE_TR_FUNCTIONS(StereoResult)
};

using Unit = Quantity::Unit;

// The drift check's limits where it measures the same, so that what is accepted today does not fail tomorrow.
constexpr calibration::DriftLimits kDrift;
constexpr double kReprojection_px = 0.15;  // half of the paper's 0.29
constexpr double kLengthSpread_percent = 0.5;
constexpr double kDepth_mm = 0.30;
constexpr double kBarShiftSigma_mm = 0.05;
constexpr double kBarTurnSigma_deg = 0.02;
constexpr double kOutlierShare = 0.15;

QString model(const calibration::StereoCalibration& result) {
  return words(result.rig.left.intrinsics().model);
}

void addHoldOut(const calibration::HoldOut& hold_out, ResultRows& rows) {
  rows.addHeading(hold_out.parts == 0
                      ? StereoResult::tr("On %1 views kept out").arg(hold_out.views)
                      : StereoResult::tr("Each of %1 views kept out in turn").arg(hold_out.views));
  rows.addLimited(StereoResult::tr("Distance from the epipolar line"),
                  {hold_out.epipolar_px, Unit::kPixel, 3}, kDrift.epipolar_px);
  rows.addLimited(StereoResult::tr("Lengths on the board, mean error"),
                  {hold_out.square_mean_percent, Unit::kPercent, 3}, kDrift.length_percent);
  rows.addLimited(StereoResult::tr("Lengths on the board, spread"),
                  {hold_out.square_std_percent, Unit::kPercent, 3}, kLengthSpread_percent);
  rows.addLimited(StereoResult::tr("Reprojection, each view by itself"),
                  {hold_out.reprojection_px, Unit::kPixel, 3}, kReprojection_px);
  rows.addLimited(StereoResult::tr("Depth"), {1e3 * hold_out.depth_rms_m, Unit::kMillimetre, 3}, kDepth_mm);
}

void addFit(const calibration::StereoCalibration& result, ResultRows& rows) {
  rows.addHeading(StereoResult::tr("On the %1 views of the solution").arg(result.views));
  rows.addLimited(StereoResult::tr("Reprojection"), {result.rms_px, Unit::kPixel, 3}, kReprojection_px);
  const auto share = static_cast<double>(result.outliers.size()) /
                     static_cast<double>(std::max<std::size_t>(result.residuals.size(), 1));
  QStringList names;
  for (const auto& name : result.outliers) names << QString::fromStdString(name);
  rows.add(StereoResult::tr("Views left out"),
           names.isEmpty() ? StereoResult::tr("none") : names.join(QStringLiteral(", ")),
           share <= kOutlierShare ? Light::kGood : Light::kWaiting);
  for (const auto& trial : result.trials)
    rows.add(StereoResult::tr("%1, reprojection of views kept out").arg(words(trial.model)),
             Quantity{trial.hold_out_px, Unit::kPixel, 3});
  rows.add(StereoResult::tr("Lens model"), model(result));
}

void addComparison(const calibration::RigComparison& comparison, ResultRows& rows) {
  rows.addHeading(StereoResult::tr("Against the calibration in force"));
  rows.add(StereoResult::tr("Distance from the epipolar line, same views"),
           Quantity{comparison.epipolar_new_px, Unit::kPixel, 3},
           Quantity{comparison.epipolar_old_px, Unit::kPixel, 3}.text());
  rows.add(StereoResult::tr("Cameras turned to each other"), Quantity{comparison.turn_deg, Unit::kDegree, 3});
  rows.add(StereoResult::tr("Cameras shifted to each other"),
           Quantity{comparison.shift_mm, Unit::kMillimetre, 2});
  rows.add(StereoResult::tr("Focal lengths changed by"),
           Quantity{comparison.focal_percent, Unit::kPercent, 2});
  for (const auto& depth : comparison.depth)
    rows.add(StereoResult::tr("Depth at %1 m changes by").arg(depth.distance_m, 0, 'f', 1),
             Quantity{depth.error_percent, Unit::kPercent, 2});
}

void addSigmas(const calibration::StereoCalibration& result, ResultRows& rows) {
  rows.addHeading(StereoResult::tr("Standard deviations"));
  const auto& turn_rad = result.bar_sigma.head<3>();
  rows.addLimited(StereoResult::tr("Turn between the cameras"),
                  {turn_rad.maxCoeff() * 180.0 / std::numbers::pi, Unit::kDegree, 4}, kBarTurnSigma_deg);
  rows.addLimited(StereoResult::tr("Shift between the cameras"),
                  {1e3 * result.bar_sigma.tail<3>().maxCoeff(), Unit::kMillimetre, 3}, kBarShiftSigma_mm);
  const std::array<QString, 2> camera{StereoResult::tr("left"), StereoResult::tr("right")};
  for (std::size_t i = 0; i < camera.size(); ++i) {
    const auto& sigma = result.lens_sigma[i];
    rows.add(StereoResult::tr("Focal length, %1").arg(camera[i]),
             Quantity{std::max(sigma.fx_px, sigma.fy_px), Unit::kPixel, 4});
    rows.add(StereoResult::tr("Principal point, %1").arg(camera[i]),
             Quantity{std::max(sigma.cx_px, sigma.cy_px), Unit::kPixel, 4});
  }
}

void addBoard(const calibration::BoardShape& shape, ResultRows& rows) {
  rows.addHeading(StereoResult::tr("The board itself"));
  rows.add(shape.is_bent ? StereoResult::tr("Bent: replace it") : StereoResult::tr("Flat to"),
           Quantity{1e3 * shape.flatness_rms_m, Unit::kMillimetre, 3}.text(),
           shape.is_bent ? Light::kWaiting : Light::kGood);
  rows.add(shape.is_stretched ? StereoResult::tr("Stretched along one side: print it anew")
                              : StereoResult::tr("Both sides to the same scale to"),
           Quantity{std::abs(shape.stretch_percent), Unit::kPercent, 3}.text(),
           shape.is_stretched ? Light::kWaiting : Light::kGood);
}

}  // namespace

QVector<ResultRow> rowsOf(const station::StereoOutcome& outcome) {
  ResultRows rows;
  if (outcome.result.hold_out) addHoldOut(*outcome.result.hold_out, rows);
  addFit(outcome.result, rows);
  if (outcome.against_in_force) addComparison(*outcome.against_in_force, rows);
  if (outcome.result.board_shape) addBoard(*outcome.result.board_shape, rows);
  addSigmas(outcome.result, rows);
  return rows.rows();
}

}  // namespace mirrorarm::ui
