#include "ui/wizards/calibration_window.h"

#include <chrono>

#include <QApplication>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/panels/action_button.h"
#include "ui/panels/header_frame.h"
#include "ui/panels/shortcut_list.h"
#include "ui/panels/stop_button.h"
#include "ui/panels/text.h"
#include "ui/wizards/capture_page.h"
#include "ui/wizards/guide_panel.h"
#include "ui/wizards/job_panel.h"
#include "ui/wizards/progress_card.h"
#include "ui/wizards/result_page.h"

namespace mirrorarm::ui {
namespace {

// As in the session's window, so that STOP is in the same place.
constexpr int kGap_px = 8;
constexpr int kLeft_px = 272;
constexpr int kRight_px = 336;
constexpr int kBottom_px = 132;

constexpr std::chrono::milliseconds kBeat{33};

}  // namespace

CalibrationWindow::CalibrationWindow(station::CalibrationPort& port, CalibrationDesk desk, Themes themes,
                                     ReadInForce read_in_force)
    : port_(port),
      desk_(std::move(desk)),
      themes_(std::move(themes)),
      read_in_force_(std::move(read_in_force)),
      presenter_(port, desk_.board),
      jobs_(new JobPanel(presenter_)),
      capture_(new CapturePage(presenter_, views_)),
      result_(new ResultPage),
      pages_(new QStackedWidget),
      guide_(new GuidePanel(presenter_, views_)),
      progress_(new ProgressCard) {
  setObjectName(QStringLiteral("calibrationWindow"));
  setWindowTitle(desk_.simulated ? tr("mirrorarm – calibration, simulation") : tr("mirrorarm – calibration"));
  jobs_->setFixedWidth(kLeft_px);
  guide_->setFixedWidth(kRight_px);
  pages_->addWidget(capture_);
  pages_->addWidget(result_);
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("page"));
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, kGap_px);
  column->setSpacing(kGap_px);
  column->addWidget(makeHeader());
  auto* grid = new QGridLayout;
  grid->setContentsMargins(kGap_px, 0, kGap_px, 0);
  grid->setSpacing(kGap_px);
  grid->addWidget(jobs_, 0, 0, 2, 1);
  grid->addWidget(pages_, 0, 1);
  grid->addWidget(guide_, 0, 2);
  grid->addWidget(makeBottom(), 1, 1, 1, 2);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch(0, 1);
  column->addLayout(grid, 1);
  setCentralWidget(page);
  setMinimumSize(1200, 720);
  join();
  setDark(false);
  jobs_->setFocus();
}

CalibrationWindow::~CalibrationWindow() = default;

QWidget* CalibrationWindow::makeHeader() {
  auto* header = new HeaderFrame(desk_.simulated);
  header->addLeft(makeText("muted", tr("Calibration")));
  const auto* leave =
      header->addAction("sessionButton", tr("To the session"), QKeySequence(QStringLiteral("Ctrl+W")));
  const auto* theme =
      header->addAction("themeButton", tr("Light or dark"), QKeySequence(QStringLiteral("Ctrl+D")));
  const auto* keys = header->addAction("keysButton", tr("Keys"), QKeySequence(Qt::Key_F1));
  connect(leave, &QPushButton::clicked, this, &CalibrationWindow::sessionWanted);
  connect(theme, &QPushButton::clicked, this, [this] { setDark(!dark_); });
  connect(keys, &QPushButton::clicked, this, [this] { (new ShortcutList(*this))->show(); });
  return header;
}

QWidget* CalibrationWindow::makeBottom() {
  auto* bottom = new QWidget;
  bottom->setFixedHeight(kBottom_px);
  auto* row = new QHBoxLayout(bottom);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap_px);
  row->addWidget(progress_, 1);
  auto* stop = new StopButton;
  stop->setFixedWidth(kRight_px);
  stop->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  connect(stop, &StopButton::stopWanted, &presenter_, &CalibrationPresenter::stop);
  row->addWidget(stop);
  return bottom;
}

void CalibrationWindow::join() {
  timer_.setInterval(kBeat);
  connect(&timer_, &QTimer::timeout, this, &CalibrationWindow::take);
  connect(&presenter_, &CalibrationPresenter::stateChanged, this, &CalibrationWindow::draw);
  connect(&presenter_, &CalibrationPresenter::resultChanged, result_,
          [this](const CalibrationResult& result) { result_->show(result); });
  readInForce();
  draw(presenter_.state());
}

void CalibrationWindow::readInForce() {
  in_force_ = read_in_force_();
  jobs_->show(in_force_.standing);
}

void CalibrationWindow::setDark(bool dark) {
  dark_ = dark;
  const Theme& theme = dark ? themes_.dark : themes_.light;
  qApp->setStyleSheet(theme.styleSheet());
  jobs_->setTheme(theme);
  capture_->setTheme(theme);
  result_->setTheme(theme);
  guide_->setTheme(theme);
}

void CalibrationWindow::start() { timer_.start(); }

void CalibrationWindow::take() {
  const station::CalibrationSnapshot snapshot = port_.snapshot();
  views_.show(snapshot);
  presenter_.show(snapshot, Clock::now());
  capture_->show(snapshot, in_force_.rig);
}

void CalibrationWindow::draw(const CalibrationState& state) {
  progress_->show(state);
  const bool has_result = state.step == CalibrationStep::kResult;
  pages_->setCurrentWidget(has_result ? static_cast<QWidget*>(result_) : capture_);
  if (state.phase == station::CalibrationPhase::kAccepted && phase_ != state.phase) readInForce();
  phase_ = state.phase;
}

}  // namespace mirrorarm::ui
