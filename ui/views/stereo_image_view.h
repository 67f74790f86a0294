#pragma once

#include <memory>

#include <QWidget>

#include "core/camera/stereo_rig.h"
#include "core/station/snapshot.h"
#include "ui/model/image_overlay.h"
#include "ui/views/theme.h"

class QPushButton;

namespace mirrorarm::ui {

/// Both camera images as they came, with the fitted ellipses, the markers' numbers, the epipolar lines and
/// why other lights were refused, and a close-up of the target. A click or the return key asks to enlarge it.
class StereoImageView : public QWidget {
  Q_OBJECT
 public:
  /// `rig` outlives the view.
  explicit StereoImageView(const camera::StereoRig& rig, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void show(const std::shared_ptr<const station::TrackedFrame>& frame);
  using QWidget::show;

 signals:
  void enlargeWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Places {
    QRectF left;
    QRectF right;
    QRectF close_up;
  };
  [[nodiscard]] Places places() const;
  [[nodiscard]] QRectF closeUpOf(const QSizeF& place) const;
  const camera::StereoRig& rig_;
  Theme theme_;
  std::shared_ptr<const station::TrackedFrame> frame_;
  StereoOverlay overlay_;
  QPushButton* refused_button_;
};

}  // namespace mirrorarm::ui
