#pragma once

#include <optional>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QWidget>

#include "core/calibration/board.h"
#include "core/camera/camera_model.h"

class QGridLayout;

namespace mirrorarm::ui {

/// Which board is shown to the cameras, and which lens model is wanted.
class BoardForm : public QWidget {
  Q_OBJECT
 public:
  explicit BoardForm(const calibration::Board& board, QWidget* parent = nullptr);

  [[nodiscard]] calibration::Board board() const;
  /// Nothing: chosen by the error on views kept out.
  [[nodiscard]] std::optional<camera::LensModel> model() const;
  /// Only the stereo cameras have one to choose.
  void setModelAsked(bool asked);

 signals:
  void changed();

 private:
  void add(QGridLayout& grid, const QString& label, QWidget* field);
  void fill(const calibration::Board& board);

  QComboBox* kind_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QDoubleSpinBox* step_mm_;
  QComboBox* model_;
};

}  // namespace mirrorarm::ui
