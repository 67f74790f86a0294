#pragma once

#include <array>

#include <QLabel>
#include <QRadioButton>
#include <QVector>

#include "ui/model/readiness.h"
#include "ui/model/session_presenter.h"
#include "ui/model/summary.h"

class QVBoxLayout;

namespace mirrorarm::ui {

class ActionButton;
class EnablingButton;
class ReportBox;
class ReportJob;

/// What to do now: a title, a sentence, the one thing to press, and below it what else is possible.
class SessionPanel : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the panel.
  SessionPanel(SessionPresenter& presenter, ReportJob& report, QWidget* parent = nullptr);

  void setChecks(const QVector<Check>& checks);
  void setSummary(const QVector<SummaryLine>& lines);

 private:
  void addActions(QVBoxLayout& column);
  void addMapping(QVBoxLayout& column);
  void draw(const SessionState& state);
  void drawActions(const SessionState& state);

  SessionPresenter& presenter_;
  QLabel* title_;
  QLabel* instruction_;
  QLabel* checks_;
  QLabel* progress_;
  QLabel* message_;
  QWidget* mapping_;
  std::array<QRadioButton*, 2> mappings_{};
  std::array<ActionButton*, kActionCount> actions_{};
  ActionButton* reset_;
  EnablingButton* enabling_;
  ReportBox* report_;
};

}  // namespace mirrorarm::ui
