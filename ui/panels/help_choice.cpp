#include "ui/panels/help_choice.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVariant>

#include "ui/model/words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

constexpr int kStep_px = 32;
constexpr int kLevel_px = 54;  // "100 %"

}  // namespace

HelpChoice::HelpChoice(HelpPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      adapts_(new ActionButton(QStringLiteral("helpAdaptsButton"), tr("Help adapts"),
                               QKeySequence(QStringLiteral("Ctrl+H")))),
      steps_(new QWidget),
      level_(makeText("figure")),
      reason_(makeText("caption")) {
  setObjectName(QStringLiteral("helpChoice"));
  adapts_->setCheckable(true);
  adapts_->setProperty("choice", true);
  adapts_->setProperty("compact", true);
  level_->setObjectName(QStringLiteral("helpLevel"));
  level_->setAccessibleName(tr("Level of help that is wanted"));
  level_->setAlignment(Qt::AlignCenter);
  level_->setFixedWidth(kLevel_px);
  reason_->setObjectName(QStringLiteral("helpReason"));
  auto* steps = new QHBoxLayout(steps_);
  steps->setContentsMargins(0, 0, 0, 0);
  less_ = addStep(*steps, QStringLiteral("lessHelpButton"), QStringLiteral("−"), tr("Less help"),
                  QStringLiteral("Ctrl+Down"));
  steps->addWidget(level_);
  more_ = addStep(*steps, QStringLiteral("moreHelpButton"), QStringLiteral("+"), tr("More help"),
                  QStringLiteral("Ctrl+Up"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(adapts_);
  row->addWidget(reason_);
  row->addStretch();
  row->addWidget(steps_);
  connect(adapts_, &QPushButton::clicked, this, [this, &presenter] {
    presenter.setAdapts(!presenter.state().adapts);
    draw(presenter.state());  // until the station has changed it
  });
  connect(less_, &QPushButton::clicked, &presenter, &HelpPresenter::lessen);
  connect(more_, &QPushButton::clicked, &presenter, &HelpPresenter::raise);
  connect(&presenter, &HelpPresenter::stateChanged, this, &HelpChoice::draw);
  draw(presenter.state());
}

QPushButton* HelpChoice::addStep(QHBoxLayout& row, const QString& name, const QString& sign,
                                 const QString& meaning, const QString& key) {
  auto* button = new QPushButton(sign);
  button->setObjectName(name);
  button->setAccessibleName(meaning);
  button->setShortcut(QKeySequence(key));
  button->setToolTip(
      QStringLiteral("%1 (%2)").arg(meaning, button->shortcut().toString(QKeySequence::NativeText)));
  button->setProperty("compact", true);
  button->setFixedWidth(kStep_px);
  button->setAutoRepeat(true);
  row.addWidget(button);
  return button;
}

void HelpChoice::draw(const HelpState& state) {
  adapts_->setEnabled(state.can_change);
  adapts_->setOn(tr("Help adapts"), state.adapts);
  less_->setEnabled(state.can_lessen);
  more_->setEnabled(state.can_raise);
  level_->setText(state.level);
  level_->setEnabled(state.can_change);
  steps_->setVisible(state.can_change);
  reason_->setVisible(!state.can_change);
  reason_->setText(state.reason);
  setToolTip(state.can_change ? QString() : words(station::Answer::kHoldsStiffly));
}

}  // namespace mirrorarm::ui
