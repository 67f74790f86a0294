#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/common/time.h"
#include "ui/panels/main_window.h"

namespace mirrorarm::workstation {

/// Walks through a whole session by pressing the window's own buttons and leaves a picture of each step.
class Tour : public QObject {
  Q_OBJECT
 public:
  /// `window` outlives the tour; pictures go to `folder`, which is made.
  Tour(ui::MainWindow& window, std::filesystem::path folder);
  void start();

 signals:
  /// The program's exit code; on 1 a line on standard error says where the tour got stuck.
  void finished(int exit_code);

 private:
  /// Wait until `ready`, let `settle` pass, take the picture `shot`, press the button `press`; empty: not.
  struct Stage {
    std::function<bool(const ui::SessionState&)> ready;
    Seconds settle{0.0};
    const char* shot = "";
    const char* press = "";
    bool stop_wanted = false;  ///< a stop here was pressed; any other is reset and the training goes on
  };
  [[nodiscard]] static std::vector<Stage> stages();
  void look();
  [[nodiscard]] bool isInterrupted(const ui::SessionState& state);
  void act(const Stage& stage);
  void next();
  void take(const char* shot);
  void press(const char* button);
  void fail(const std::string& reason);

  ui::MainWindow& window_;
  std::filesystem::path folder_;
  std::vector<Stage> stages_;
  std::size_t stage_ = 0;
  TimePoint waiting_since_{};
  TimePoint ready_since_{};
  bool ready_ = false;
  bool resuming_ = false;
  QTimer timer_;
};

}  // namespace mirrorarm::workstation
