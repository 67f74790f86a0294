#pragma once

#include <QLabel>
#include <QTableView>
#include <QWidget>

#include "ui/model/calibration_result.h"
#include "ui/model/result_list.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

class LightDelegate;
class StatusLight;

/// The figures of a result, judged.
class ResultPage : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPage(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const CalibrationResult& result);
  using QWidget::show;

 private:
  ResultList list_;
  LightDelegate* delegate_;
  StatusLight* light_;
  QLabel* verdict_;
  QTableView* table_;
};

}  // namespace mirrorarm::ui
