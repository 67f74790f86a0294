#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <QObject>
#include <QTimer>
#include <QWidget>

#include "core/common/time.h"

namespace mirrorarm::workstation {

/// Walks through a window by pressing its own buttons and leaves a picture of each step.
class Tour : public QObject {
  Q_OBJECT
 public:
  /// Wait until `ready`, let `settle` pass, take the picture `shot`, press the button `press`; empty: not.
  struct Stage {
    std::function<bool()> ready;
    Seconds settle{0.0};
    const char* shot = "";
    const char* press = "";
    bool stop_wanted = false;  ///< a stop here was pressed; any other is an interruption
    Seconds patience{60.0};    ///< for `ready`, on a machine without graphics hardware
  };

  /// `window` outlives the tour; pictures go to `folder`, which is made.
  Tour(QWidget& window, std::vector<Stage> stages, std::filesystem::path folder);
  void start();

 signals:
  /// The program's exit code; on 1 a line on standard error says where the tour got stuck.
  void finished(int exit_code);

 protected:
  /// Whether something came in between that has to be cleared first; clears it by and by.
  [[nodiscard]] virtual bool isInterrupted() { return false; }
  [[nodiscard]] const Stage& stage() const { return stages_[stage_]; }
  void press(const char* button);

 private:
  void look();
  void act(const Stage& stage);
  void next();
  void take(const char* shot);
  void fail(const std::string& reason);

  QWidget& window_;
  std::filesystem::path folder_;
  std::vector<Stage> stages_;
  std::size_t stage_ = 0;
  TimePoint waiting_since_{};
  TimePoint ready_since_{};
  bool ready_ = false;
  QTimer timer_;
};

}  // namespace mirrorarm::workstation
