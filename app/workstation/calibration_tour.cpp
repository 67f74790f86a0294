#include "app/workstation/calibration_tour.h"

namespace mirrorarm::workstation {
namespace {

using station::CalibrationAction;
using station::CalibrationPhase;

constexpr Seconds kCapturing{900.0};  // the robot drives to every view at a therapy's speed
constexpr Seconds kSolving{300.0};

}  // namespace

std::vector<Tour::Stage> CalibrationTour::stages(const ui::CalibrationPresenter& presenter) {
  const auto in = [&presenter](CalibrationPhase phase) {
    return [&presenter, phase] { return presenter.state().phase == phase && !presenter.state().stopped; };
  };
  const auto can_reset = [&presenter] { return presenter.state().can_reset; };
  const auto halfway = [&presenter] { return presenter.state().progress_percent >= 50; };
  const auto enough = [&presenter] { return presenter.state().primary == CalibrationAction::kSolve; };
  return {{in(CalibrationPhase::kIdle), Seconds(2.0), "1-choose", "beginButton"},
          {in(CalibrationPhase::kCapturing), Seconds(2.0), "2-capture", "drivingButton"},
          {in(CalibrationPhase::kCapturing), Seconds(4.0), "3-driving", "stopButton"},
          {can_reset, Seconds(1.0), "4-stopped", "resetStopButton", true},
          {in(CalibrationPhase::kCapturing), Seconds(1.5), "", "drivingButton"},
          {halfway, Seconds(0.5), "5-halfway", "themeButton", false, kCapturing},
          {in(CalibrationPhase::kCapturing), Seconds(0.5), "6-dark", "themeButton"},
          {enough, Seconds(0.5), "7-enough", "solveButton", false, kCapturing},
          {in(CalibrationPhase::kSolved), Seconds(1.0), "8-result", "themeButton", false, kSolving},
          {in(CalibrationPhase::kSolved), Seconds(0.5), "9-result-dark", "themeButton"},
          {in(CalibrationPhase::kSolved), Seconds(0.5), "", "acceptButton"},
          {in(CalibrationPhase::kAccepted), Seconds(1.0), "10-in-force", ""}};
}

CalibrationTour::CalibrationTour(ui::CalibrationWindow& window, std::filesystem::path folder)
    : Tour(window, stages(window.presenter()), std::move(folder)) {}

}  // namespace mirrorarm::workstation
