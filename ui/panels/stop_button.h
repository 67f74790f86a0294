#pragma once

#include <QPushButton>

namespace mirrorarm::ui {

/// STOP: always in the same place, never disabled, acts when it is pressed down, asks nothing. The escape key
/// does the same wherever the focus is.
class StopButton : public QPushButton {
  Q_OBJECT
 public:
  static constexpr int kSmallestHeight_px = 96;

  explicit StopButton(QWidget* parent = nullptr);
  ~StopButton() override;

 signals:
  void stopWanted();

 protected:
  /// Watches the whole application for the escape key.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace mirrorarm::ui
