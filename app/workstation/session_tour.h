#pragma once

#include "app/workstation/tour.h"
#include "ui/panels/main_window.h"

namespace mirrorarm::workstation {

/// Through a whole session.
class SessionTour : public Tour {
  Q_OBJECT
 public:
  /// `window` outlives the tour.
  SessionTour(ui::MainWindow& window, std::filesystem::path folder);

 protected:
  /// A target that left the view stops the robot; a therapist resets that and goes on.
  [[nodiscard]] bool isInterrupted() override;

 private:
  [[nodiscard]] static std::vector<Stage> stages(const ui::SessionPresenter& session);

  const ui::SessionPresenter& session_;
  bool resuming_ = false;
};

}  // namespace mirrorarm::workstation
