#include "ui/panels/session_panel.h"

#include <QVBoxLayout>

#include "ui/model/words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/enabling_button.h"
#include "ui/panels/report_box.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

using therapy::Action;

struct Key {
  Action action;
  const char* name;
  Qt::Key key;
};
// In the order in which they stand below each other.
constexpr std::array<Key, kActionCount> kKeys{{{Action::kFinishTeaching, "keepMarkersButton", Qt::Key_F3},
                                               {Action::kStart, "startButton", Qt::Key_F5},
                                               {Action::kPause, "pauseButton", Qt::Key_F6},
                                               {Action::kAlign, "alignButton", Qt::Key_F4},
                                               {Action::kTeach, "teachButton", Qt::Key_F2},
                                               {Action::kFinish, "finishButton", Qt::Key_F7},
                                               {Action::kNewSession, "newSessionButton", Qt::Key_F10}}};

QLabel* makeWrapped(const char* role, const QString& name) {
  auto* label = makeText(role);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

void setTextOrHide(QLabel& label, const QString& text) {
  label.setText(text);
  label.setVisible(!text.isEmpty());
}

}  // namespace

SessionPanel::SessionPanel(SessionPresenter& presenter, ReportJob& report, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      title_(makeWrapped("title", QStringLiteral("stepTitle"))),
      instruction_(makeWrapped("plain", QStringLiteral("stepInstruction"))),
      checks_(makeWrapped("plain", QStringLiteral("readinessChecks"))),
      progress_(makeWrapped("figure", QStringLiteral("stepProgress"))),
      message_(makeWrapped("notice", QStringLiteral("stepMessage"))),
      mapping_(new QWidget),
      reset_(
          new ActionButton(QStringLiteral("resetStopButton"), tr("Reset stop"), QKeySequence(Qt::Key_F12))),
      enabling_(new EnablingButton),
      report_(new ReportBox(report)) {
  setObjectName(QStringLiteral("sessionPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* card = makeCard(QStringLiteral("sessionCard"));
  column->addWidget(card);
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->setSpacing(8);
  for (QWidget* widget : std::initializer_list<QWidget*>{title_, instruction_, checks_, progress_})
    inside->addWidget(widget);
  addMapping(*inside);
  reset_->setPrimary(true);
  inside->addWidget(reset_);
  inside->addWidget(enabling_);
  inside->addWidget(report_);
  addActions(*inside);
  inside->addWidget(message_);
  inside->addStretch();
  connect(enabling_, &EnablingButton::said, &presenter_, &SessionPresenter::setEnabling);
  connect(reset_, &QPushButton::clicked, &presenter_, &SessionPresenter::resetStop);
  connect(&presenter_, &SessionPresenter::stateChanged, this, &SessionPanel::draw);
  draw(presenter_.state());
}

void SessionPanel::addMapping(QVBoxLayout& column) {
  auto* choices = new QVBoxLayout(mapping_);
  choices->setContentsMargins(0, 0, 0, 0);
  choices->setSpacing(2);
  choices->addWidget(makeText("heading", tr("The impaired arm moves")));
  for (const auto mapping : {therapy::Mapping::kFollow, therapy::Mapping::kMirror}) {
    auto* choice = new QRadioButton(words(mapping));
    const bool mirror = mapping == therapy::Mapping::kMirror;
    choice->setObjectName(mirror ? QStringLiteral("mirrorChoice") : QStringLiteral("parallelChoice"));
    choice->setAccessibleName(words(mapping));
    choice->setShortcut(QKeySequence(mirror ? QStringLiteral("Ctrl+M") : QStringLiteral("Ctrl+P")));
    choice->setToolTip(choice->shortcut().toString(QKeySequence::NativeText));
    connect(choice, &QRadioButton::clicked, this, [this, mapping] { presenter_.setMapping(mapping); });
    choices->addWidget(choice);
    mappings_[static_cast<std::size_t>(mapping)] = choice;
  }
  column.addWidget(mapping_);
}

void SessionPanel::addActions(QVBoxLayout& column) {
  for (const auto& [action, name, key] : kKeys) {
    auto* button = new ActionButton(QLatin1String(name), words(action), QKeySequence(key));
    connect(button, &QPushButton::clicked, this, [this, wanted = action] { presenter_.ask(wanted); });
    column.addWidget(button);
    actions_[static_cast<std::size_t>(action)] = button;
  }
}

void SessionPanel::draw(const SessionState& state) {
  title_->setText(state.title);
  instruction_->setText(state.instruction);
  setTextOrHide(*progress_, state.progress);
  setTextOrHide(*message_, state.message);
  checks_->setVisible(state.step == Step::kPrepare && !state.stopped);
  mapping_->setVisible(state.can_choose_mapping);
  for (std::size_t i = 0; i < mappings_.size(); ++i)
    mappings_[i]->setChecked(i == static_cast<std::size_t>(state.mapping));
  reset_->setVisible(state.stopped);
  reset_->setEnabled(state.can_reset);
  enabling_->setVisible(state.enabling_needed);
  enabling_->show(state.enabling);
  report_->setVisible(state.step == Step::kReport && !state.stopped);
  report_->setSession(state.session, state.can_report);
  drawActions(state);
}

void SessionPanel::drawActions(const SessionState& state) {
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const auto action = static_cast<Action>(i);
    actions_[i]->setPrimary(state.primary == action);
    actions_[i]->setVisible(state.allows(action));
    actions_[i]->setEnabled(state.allows(action));
  }
}

void SessionPanel::setChecks(const QVector<Check>& checks) {
  QStringList lines;
  for (const auto& check : checks)
    lines << (check.passed ? QStringLiteral("✔  ") : QStringLiteral("✖  ")) + check.text;
  checks_->setText(lines.join(QLatin1Char('\n')));
}

void SessionPanel::setSummary(const QVector<SummaryLine>& lines) { report_->setSummary(lines); }

}  // namespace mirrorarm::ui
