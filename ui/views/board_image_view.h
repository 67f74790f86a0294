#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QWidget>

#include "ui/model/board_overlay.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// Both camera images with the board that is shown to them, side by side or, where that makes them larger,
/// one above the other.
class BoardImageView : public QWidget {
  Q_OBJECT
 public:
  explicit BoardImageView(QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  /// `rig`: see boardOverlaysOf().
  void show(const station::CalibrationSnapshot& snapshot, const std::optional<camera::StereoRig>& rig);
  using QWidget::show;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] std::array<QRectF, 2> places(const QSizeF& image) const;

  Theme theme_;
  std::shared_ptr<const station::BoardFrame> frame_;
  std::array<BoardOverlay, 2> overlays_;
};

}  // namespace mirrorarm::ui
