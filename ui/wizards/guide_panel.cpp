#include "ui/wizards/guide_panel.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/model/calibration_words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/enabling_button.h"
#include "ui/panels/text.h"
#include "ui/wizards/lights_list.h"
#include "ui/wizards/tables.h"

namespace mirrorarm::ui {
namespace {

using station::CalibrationAction;

struct Key {
  CalibrationAction action;
  const char* name;
  const char* key;
};
// In the order in which they stand below each other; what the robot does and what ends everything is not
// beside what is pressed often.
constexpr std::array<Key, 6> kKeys{{{CalibrationAction::kBegin, "beginButton", "F2"},
                                    {CalibrationAction::kCapture, "captureButton", "F3"},
                                    {CalibrationAction::kSolve, "solveButton", "F6"},
                                    {CalibrationAction::kAccept, "acceptButton", "F7"},
                                    {CalibrationAction::kDiscard, "backButton", "F8"},
                                    {CalibrationAction::kCancel, "cancelButton", "Shift+F9"}}};
constexpr std::array<Key, 2> kToggles{{{CalibrationAction::kSetAutomatic, "automaticButton", "F4"},
                                       {CalibrationAction::kSetDriving, "drivingButton", "F5"}}};

QLabel* makeWrapped(const char* role, const char* name) {
  auto* label = makeText(role);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

}  // namespace

GuidePanel::GuidePanel(CalibrationPresenter& presenter, ViewList& views, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      title_(makeWrapped("title", "guideTitle")),
      instruction_(makeWrapped("plain", "guideInstruction")),
      lights_(new LightsList),
      reset_(
          new ActionButton(QStringLiteral("resetStopButton"), tr("Reset stop"), QKeySequence(Qt::Key_F12))),
      enabling_(new EnablingButton),
      residuals_(makeResiduals(views)) {
  setObjectName(QStringLiteral("guidePanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* card = makeCard(QStringLiteral("guideCard"));
  column->addWidget(card);
  column->addWidget(residuals_, 1);
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->setSpacing(8);
  inside->addWidget(title_);
  inside->addWidget(instruction_);
  inside->addWidget(lights_);
  inside->addStretch();
  reset_->setPrimary(true);
  inside->addWidget(reset_);
  inside->addWidget(enabling_);
  addToggles(*inside);
  addActions(*inside);
  connect(reset_, &QPushButton::clicked, &presenter_, &CalibrationPresenter::resetStop);
  connect(enabling_, &EnablingButton::said, &presenter_, &CalibrationPresenter::setEnabling);
  connect(&presenter_, &CalibrationPresenter::stateChanged, this, &GuidePanel::draw);
  draw(presenter_.state());
}

void GuidePanel::addToggles(QVBoxLayout& column) {
  for (const auto& [action, name, key] : kToggles) {
    auto* toggle = new ActionButton(QLatin1String(name), words(action), QKeySequence(QLatin1String(key)));
    toggle->setCheckable(true);
    toggle->setProperty("choice", true);
    actions_[static_cast<std::size_t>(action)] = toggle;
    column.addWidget(toggle);
  }
  connect(actions_[static_cast<std::size_t>(CalibrationAction::kSetAutomatic)], &QPushButton::clicked, this,
          [this] { presenter_.setAutomatic(!presenter_.state().automatic); });
  connect(actions_[static_cast<std::size_t>(CalibrationAction::kSetDriving)], &QPushButton::clicked, this,
          [this] { presenter_.setDriving(!presenter_.state().driving); });
}

void GuidePanel::addActions(QVBoxLayout& column) {
  for (const auto& [action, name, key] : kKeys) {
    auto* button = new ActionButton(QLatin1String(name), words(action), QKeySequence(QLatin1String(key)));
    connect(button, &QPushButton::clicked, this, [this, wanted = action] { presenter_.ask(wanted); });
    column.addWidget(button);
    actions_[static_cast<std::size_t>(action)] = button;
  }
}

QWidget* GuidePanel::makeResiduals(ViewList& views) {
  auto* card = makeCard(QStringLiteral("residualsCard"));
  auto* table = makeTable(QStringLiteral("residualTable"), tr("Residuals of the views"));
  table->setModel(&views);
  table->setColumnHidden(ViewList::kPoints, true);
  table->horizontalHeader()->setSectionResizeMode(ViewList::kRemark, QHeaderView::Stretch);
  card->layout()->addWidget(makeText("heading", tr("Residuals of the views")));
  card->layout()->addWidget(table);
  return card;
}

void GuidePanel::setTheme(const Theme& theme) { lights_->setTheme(theme); }

void GuidePanel::draw(const CalibrationState& state) {
  title_->setText(state.title);
  instruction_->setText(state.instruction);
  lights_->setVisible(state.step == CalibrationStep::kCapture);
  lights_->show(state.lights);
  residuals_->setVisible(state.step == CalibrationStep::kResult);
  reset_->setVisible(state.stopped);
  reset_->setEnabled(state.can_reset);
  enabling_->setVisible(state.enabling_needed && state.step == CalibrationStep::kCapture);
  enabling_->show(state.enabling);
  drawActions(state);
  moveFocus(state);
}

// What had the focus may have gone; it must not fall on what ends everything.
void GuidePanel::moveFocus(const CalibrationState& state) {
  if (state.phase == phase_) return;
  phase_ = state.phase;
  const auto next = state.primary.value_or(CalibrationAction::kSetAutomatic);
  if (auto* button = actions_[static_cast<std::size_t>(next)]; button != nullptr && button->isEnabled())
    button->setFocus();
}

void GuidePanel::drawActions(const CalibrationState& state) {
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (actions_[i] == nullptr) continue;
    const auto action = static_cast<CalibrationAction>(i);
    actions_[i]->setPrimary(state.primary == action && state.allows(action));
    actions_[i]->setVisible(state.allows(action));
    actions_[i]->setEnabled(state.allows(action));
  }
  const auto set = [this](CalibrationAction action, bool on) {
    actions_[static_cast<std::size_t>(action)]->setOn(words(action), on);
  };
  set(CalibrationAction::kSetAutomatic, state.automatic);
  set(CalibrationAction::kSetDriving, state.driving);
}

}  // namespace mirrorarm::ui
