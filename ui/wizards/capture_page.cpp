#include "ui/wizards/capture_page.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/model/calibration_words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/text.h"
#include "ui/views/board_image_view.h"
#include "ui/wizards/coverage_matrix.h"
#include "ui/wizards/tables.h"

namespace mirrorarm::ui {
namespace {

using station::CalibrationAction;

constexpr int kGap_px = 8;
constexpr int kCoverage_px = 292;
constexpr int kLower_px = 264;

}  // namespace

CapturePage::CapturePage(CalibrationPresenter& presenter, ViewList& views, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      images_(new BoardImageView),
      matrix_(new CoverageMatrix),
      table_(makeTable(QStringLiteral("viewTable"), tr("Views taken"))),
      remove_(new ActionButton(QStringLiteral("removeViewButton"), words(CalibrationAction::kRemoveView),
                               QKeySequence(Qt::Key_Delete))),
      undo_(new ActionButton(QStringLiteral("undoButton"), words(CalibrationAction::kUndoRemove),
                             QKeySequence(QStringLiteral("Ctrl+Z")))) {
  setObjectName(QStringLiteral("capturePage"));
  table_->setModel(&views);
  table_->horizontalHeader()->setSectionResizeMode(ViewList::kRemark, QHeaderView::Stretch);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  column->addWidget(images_, 1);
  auto* lower = new QHBoxLayout;
  lower->setSpacing(kGap_px);
  lower->addWidget(makeViews(), 1);
  lower->addWidget(makeCoverage());
  column->addLayout(lower);
  connect(remove_, &QPushButton::clicked, this, &CapturePage::removeChosen);
  connect(undo_, &QPushButton::clicked, this, [this] { presenter_.ask(CalibrationAction::kUndoRemove); });
  connect(&presenter_, &CalibrationPresenter::stateChanged, this, &CapturePage::enableButtons);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &CapturePage::enableButtons);
  connect(&views, &ViewList::modelReset, this, &CapturePage::enableButtons);
  enableButtons();
}

QWidget* CapturePage::makeCoverage() {
  auto* card = makeCard(QStringLiteral("coverageCard"));
  card->setFixedSize(kCoverage_px, kLower_px);
  card->layout()->addWidget(makeText("heading", tr("Views by tilt and distance in cm")));
  static_cast<QVBoxLayout*>(card->layout())->addWidget(matrix_, 1);
  return card;
}

QWidget* CapturePage::makeViews() {
  auto* card = makeCard(QStringLiteral("viewsCard"));
  card->setFixedHeight(kLower_px);
  auto* heading = makeText("heading", tr("&Views taken"));
  heading->setBuddy(table_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(remove_);
  buttons->addWidget(undo_);
  buttons->addStretch();
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->addWidget(heading);
  inside->addWidget(table_, 1);
  inside->addLayout(buttons);
  return card;
}

void CapturePage::setTheme(const Theme& theme) {
  images_->setTheme(theme);
  matrix_->setTheme(theme);
}

void CapturePage::show(const station::CalibrationSnapshot& snapshot,
                       const std::optional<camera::StereoRig>& rig) {
  images_->show(snapshot, rig);
  matrix_->show(snapshot.coverage);
}

void CapturePage::enableButtons() {
  remove_->setEnabled(presenter_.state().allows(CalibrationAction::kRemoveView) &&
                      table_->selectionModel()->hasSelection());
  undo_->setEnabled(presenter_.state().allows(CalibrationAction::kUndoRemove));
}

void CapturePage::removeChosen() {
  const auto chosen = table_->selectionModel()->selectedRows();
  if (!chosen.isEmpty()) presenter_.removeView(static_cast<std::size_t>(chosen.front().row()));
}

}  // namespace mirrorarm::ui
