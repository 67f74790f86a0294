#include "ui/panels/report_box.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QGridLayout>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/panels/action_button.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {

ReportBox::ReportBox(ReportJob& job, QWidget* parent)
    : QWidget(parent),
      job_(job),
      summary_(new QGridLayout),
      make_(
          new ActionButton(QStringLiteral("makeReportButton"), tr("Make report"), QKeySequence(Qt::Key_F8))),
      open_(
          new ActionButton(QStringLiteral("openReportButton"), tr("Open report"), QStringLiteral("Ctrl+O"))),
      result_(makeText("notice")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  summary_->setVerticalSpacing(1);
  column->addLayout(summary_);
  for (QWidget* widget : std::initializer_list<QWidget*>{make_, result_, open_}) column->addWidget(widget);
  make_->setPrimary(true);
  result_->setObjectName(QStringLiteral("reportResult"));
  result_->setWordWrap(true);
  result_->hide();
  open_->hide();
  connect(make_, &QPushButton::clicked, this, [this] { job_.start(session_); });
  connect(open_, &QPushButton::clicked, this, &ReportBox::open);
  connect(&job_, &ReportJob::started, this, &ReportBox::showStarted);
  connect(&job_, &ReportJob::finished, this, &ReportBox::showResult);
}

void ReportBox::setSession(std::int64_t session, bool can_report) {
  if (session != session_) {
    result_->hide();
    open_->hide();
    make_->show();
  }
  session_ = session;
  can_report_ = can_report;
  make_->setEnabled(can_report && !job_.isBusy());
}

void ReportBox::setSummary(const QVector<SummaryLine>& lines) {
  if (lines == lines_) return;
  lines_ = lines;
  for (int row = 0; row < lines.size(); ++row) {
    auto* item = summary_->itemAtPosition(row, 1);
    if (item == nullptr) {
      summary_->addWidget(makeText("muted"), row, 0);
      summary_->addWidget(makeText("plain"), row, 1, Qt::AlignRight);
    }
    static_cast<QLabel*>(summary_->itemAtPosition(row, 0)->widget())->setText(lines[row].name);
    static_cast<QLabel*>(summary_->itemAtPosition(row, 1)->widget())->setText(lines[row].value);
  }
}

void ReportBox::showStarted() {
  make_->setEnabled(false);
  result_->setText(tr("The report is being made …"));
  result_->show();
}

void ReportBox::showResult(const ReportResult& result) {
  const bool made = result.reason.isEmpty();
  file_ = result.file;
  result_->setText(made ? tr("Report saved as %1").arg(QFileInfo(file_).fileName())
                        : tr("The report could not be made: %1").arg(result.reason));
  result_->setToolTip(file_);
  result_->show();
  open_->setVisible(made);
  make_->setEnabled(can_report_);
  make_->setVisible(!made);
}

void ReportBox::open() { QDesktopServices::openUrl(QUrl::fromLocalFile(file_)); }

}  // namespace mirrorarm::ui
