#pragma once

#include <QLabel>
#include <QVector>
#include <QWidget>

#include "ui/model/report_job.h"
#include "ui/model/summary.h"

class QGridLayout;

namespace mirrorarm::ui {

class ActionButton;

/// The last step: what the session came to, and its report as a PDF.
class ReportBox : public QWidget {
  Q_OBJECT
 public:
  /// `job` outlives the box.
  explicit ReportBox(ReportJob& job, QWidget* parent = nullptr);

  void setSession(std::int64_t session, bool can_report);
  void setSummary(const QVector<SummaryLine>& lines);

 private:
  void showStarted();
  void showResult(const ReportResult& result);
  void open();

  ReportJob& job_;
  std::int64_t session_ = 0;
  bool can_report_ = false;
  QString file_;
  QVector<SummaryLine> lines_;
  QGridLayout* summary_;
  ActionButton* make_;
  ActionButton* open_;
  QLabel* result_;
};

}  // namespace mirrorarm::ui
