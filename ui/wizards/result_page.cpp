#include "ui/wizards/result_page.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/panels/status_light.h"
#include "ui/panels/text.h"
#include "ui/wizards/light_delegate.h"
#include "ui/wizards/tables.h"

namespace mirrorarm::ui {

ResultPage::ResultPage(QWidget* parent)
    : QWidget(parent),
      delegate_(new LightDelegate(this)),
      light_(new StatusLight),
      verdict_(makeText("status")),
      table_(makeTable(QStringLiteral("resultTable"), tr("Figures of the result"))) {
  setObjectName(QStringLiteral("resultPage"));
  verdict_->setObjectName(QStringLiteral("resultVerdict"));
  verdict_->setWordWrap(true);
  table_->setModel(&list_);
  table_->setItemDelegateForColumn(ResultList::kFigure, delegate_);
  table_->horizontalHeader()->setSectionResizeMode(ResultList::kValue, QHeaderView::Stretch);
  auto* card = makeCard(QStringLiteral("resultCard"));
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  auto* line = new QHBoxLayout;
  line->setSpacing(10);
  line->addWidget(light_);
  line->addWidget(verdict_, 1);
  inside->addLayout(line);
  inside->addWidget(table_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(card);
}

void ResultPage::setTheme(const Theme& theme) {
  light_->setTheme(theme);
  delegate_->setTheme(theme);
  table_->viewport()->update();
}

void ResultPage::show(const CalibrationResult& result) {
  light_->setLight(result.light);
  verdict_->setText(result.verdict);
  table_->clearSpans();
  list_.show(result);
  for (int row = 0; row < list_.rowCount(); ++row)
    if (list_.isHeading(row)) table_->setSpan(row, 0, 1, ResultList::kColumnCount);
}

}  // namespace mirrorarm::ui
