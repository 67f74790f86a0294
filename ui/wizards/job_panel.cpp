#include "ui/wizards/job_panel.h"

#include <QVBoxLayout>

#include "ui/model/calibration_words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/status_light.h"
#include "ui/panels/step_rail.h"
#include "ui/panels/text.h"
#include "ui/wizards/board_form.h"

namespace mirrorarm::ui {
namespace {

using station::CalibrationJob;

constexpr int kGap_px = 8;

constexpr std::array<const char*, station::kCalibrationJobCount> kNames{"stereoJob", "handEyeJob", "clockJob",
                                                                        "driftJob"};

QStringList stepNames() {
  QStringList names;
  for (int i = 0; i < kCalibrationStepCount; ++i) names << nameOf(static_cast<CalibrationStep>(i));
  return names;
}

QVBoxLayout* addCard(QVBoxLayout& column, const QString& name, const QString& heading) {
  auto* card = makeCard(name);
  column.addWidget(card);
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->addWidget(makeText("heading", heading));
  return inside;
}

}  // namespace

JobPanel::JobPanel(CalibrationPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      rail_(new StepRail(stepNames())),
      board_(new BoardForm(presenter.board())) {
  setObjectName(QStringLiteral("jobPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  auto* card = makeCard(QStringLiteral("railCard"));
  card->layout()->setContentsMargins(4, 4, 4, 4);
  card->layout()->addWidget(rail_);
  column->addWidget(card);
  addJobs(*addCard(*column, QStringLiteral("jobCard"), tr("What to calibrate")));
  addCard(*column, QStringLiteral("boardCard"), tr("The board"))->addWidget(board_);
  column->addStretch();
  connect(board_, &BoardForm::changed, this, [this] {
    presenter_.setBoard(board_->board());
    presenter_.setModel(board_->model());
  });
  connect(&presenter_, &CalibrationPresenter::stateChanged, this, &JobPanel::draw);
  setFocusProxy(jobs_.front().button);
  draw(presenter_.state());
}

void JobPanel::addJobs(QVBoxLayout& column) {
  column.setSpacing(2);
  for (std::size_t i = 0; i < jobs_.size(); ++i) addJob(column, static_cast<CalibrationJob>(i));
}

void JobPanel::addJob(QVBoxLayout& column, CalibrationJob job) {
  const auto index = static_cast<std::size_t>(job);
  auto* button = new ActionButton(QLatin1String(kNames[index]), words(job),
                                  QKeySequence(QStringLiteral("Ctrl+%1").arg(index + 1)));
  button->setCheckable(true);
  button->setProperty("choice", true);
  connect(button, &QPushButton::clicked, this, [this, job] {
    presenter_.choose(job);
    draw(presenter_.state());
  });
  auto* light = new StatusLight(StatusLight::kSmall_px);
  auto* standing = makeText("caption");
  auto* line = new QHBoxLayout;
  line->setContentsMargins(6, 0, 0, 4);
  line->addWidget(light);
  line->addWidget(standing, 1);
  column.addWidget(button);
  column.addLayout(line);
  jobs_[index] = {button, light, standing};
}

void JobPanel::setTheme(const Theme& theme) {
  rail_->setTheme(theme);
  for (const auto& job : jobs_) job.light->setTheme(theme);
}

void JobPanel::show(const StandingLines& standing) {
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    jobs_[i].light->setLight(standing[i].light);
    jobs_[i].standing->setText(standing[i].text);
    jobs_[i].button->setAccessibleDescription(standing[i].text);
  }
}

void JobPanel::draw(const CalibrationState& state) {
  rail_->setStep(static_cast<int>(state.step));
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    jobs_[i].button->setChecked(i == static_cast<std::size_t>(state.job));
    jobs_[i].button->setEnabled(state.can_choose || jobs_[i].button->isChecked());
  }
  board_->setEnabled(state.can_choose);
  board_->setModelAsked(state.job == CalibrationJob::kStereo);
}

}  // namespace mirrorarm::ui
