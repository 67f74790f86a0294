#pragma once

#include "app/workstation/tour.h"
#include "ui/wizards/calibration_window.h"

namespace mirrorarm::workstation {

/// Through the calibration that was chosen, the robot driving, to what is in force.
class CalibrationTour : public Tour {
  Q_OBJECT
 public:
  /// `window` outlives the tour.
  CalibrationTour(ui::CalibrationWindow& window, std::filesystem::path folder);

 private:
  [[nodiscard]] static std::vector<Stage> stages(const ui::CalibrationPresenter& presenter);
};

}  // namespace mirrorarm::workstation
