#include "ui/panels/main_window.h"

#include <QApplication>
#include <QVBoxLayout>

#include "ui/panels/action_button.h"
#include "ui/panels/alarm_bar.h"
#include "ui/panels/header_bar.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/quality_panel.h"
#include "ui/panels/robot_panel.h"
#include "ui/panels/session_panel.h"
#include "ui/panels/shortcut_list.h"
#include "ui/panels/step_rail.h"
#include "ui/panels/stop_button.h"
#include "ui/panels/text.h"
#include "ui/views/scene_view.h"
#include "ui/views/stereo_image_view.h"

namespace mirrorarm::ui {
namespace {

constexpr int kGap_px = 8;
constexpr int kLeft_px = 272;
constexpr int kRight_px = 336;
constexpr int kStrip_px = 176;
constexpr int kBottom_px = 132;
constexpr double kTraceWindow_s = 15.0;
constexpr int kBeatsAPlot = 3;  // a plot is costly and is read slowly

QVBoxLayout* columnOf(QWidget* widget) {
  auto* column = new QVBoxLayout(widget);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  return column;
}

QStringList stepNames() {
  QStringList names;
  for (int i = 0; i < kStepCount; ++i) names << nameOf(static_cast<Step>(i));
  return names;
}

}  // namespace

MainWindow::MainWindow(station::StationPort& port, Workplace workplace, Themes themes,
                       ReportJob::Read read_report)
    : workplace_(std::move(workplace)),
      themes_(std::move(themes)),
      feed_(port),
      session_(port),
      help_(port),
      robot_(workplace_),
      trace_(workplace_.X_FE, kTraceWindow_s),
      journal_(log_),
      report_(std::move(read_report)),
      header_(new HeaderBar(workplace_.simulated)),
      rail_(new StepRail(stepNames())),
      session_panel_(new SessionPanel(session_, report_)),
      scene_(new SceneView(workplace_)),
      images_(new StereoImageView(workplace_.rig)),
      quality_panel_(new QualityPanel),
      robot_panel_(new RobotPanel(help_)),
      alarm_bar_(new AlarmBar(alarms_)) {
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(workplace_.simulated ? tr("mirrorarm – simulation") : QStringLiteral("mirrorarm"));
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("page"));
  auto* column = columnOf(page);
  column->addWidget(header_);
  auto* middle = new QHBoxLayout;
  middle->setContentsMargins(kGap_px, 0, kGap_px, 0);
  middle->setSpacing(kGap_px);
  middle->addWidget(makeLeft());
  middle->addWidget(makeMiddle(), 1);
  middle->addWidget(makeRight());
  column->addLayout(middle, 1);
  column->addWidget(makeBottom());
  setCentralWidget(page);
  setMinimumSize(1200, 720);
  join();
  setDark(false);
}

MainWindow::~MainWindow() = default;

QWidget* MainWindow::makeLeft() {
  auto* left = new QWidget;
  left->setFixedWidth(kLeft_px);
  auto* column = columnOf(left);
  auto* card = makeCard(QStringLiteral("railCard"));
  card->layout()->setContentsMargins(4, 4, 4, 4);
  card->layout()->addWidget(rail_);
  column->addWidget(card);
  column->addWidget(session_panel_, 1);
  return left;
}

QWidget* MainWindow::makeMiddle() {
  auto* middle = new QWidget;
  auto* column = columnOf(middle);
  column->addWidget(scene_, 1);
  images_->setFixedHeight(kStrip_px);
  column->addWidget(images_);
  return middle;
}

QWidget* MainWindow::makeRight() {
  auto* right = new QWidget;
  right->setFixedWidth(kRight_px);
  auto* column = columnOf(right);
  column->addWidget(quality_panel_, 1);
  column->addWidget(robot_panel_);
  return right;
}

QWidget* MainWindow::makeBottom() {
  auto* bottom = new QWidget;
  bottom->setFixedHeight(kBottom_px);
  auto* row = new QHBoxLayout(bottom);
  row->setContentsMargins(kGap_px, 0, kGap_px, kGap_px);
  row->setSpacing(kGap_px);
  auto* column = new QVBoxLayout;
  column->setSpacing(kGap_px);
  column->addWidget(alarm_bar_);
  column->addWidget(new LogPanel(log_), 1);
  row->addLayout(column, 1);
  auto* stop = new StopButton;
  stop->setFixedWidth(kRight_px);
  stop->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  connect(stop, &StopButton::stopWanted, &session_, &SessionPresenter::stop);
  row->addWidget(stop);
  return bottom;
}

void MainWindow::join() {
  connect(&feed_, &LiveFeed::taken, this, &MainWindow::present);
  connect(&session_, &SessionPresenter::stateChanged, rail_,
          [this](const SessionState& s) { rail_->setStep(static_cast<int>(s.step)); });
  connect(&session_, &SessionPresenter::stateChanged, header_,
          [this](const SessionState& s) { header_->setCalibrationAllowed(s.can_calibrate); });
  connect(&tracking_, &TrackingPresenter::stateChanged, quality_panel_,
          [this](const TrackingState& state) { quality_panel_->show(state); });
  connect(&robot_, &RobotPresenter::figuresChanged, robot_panel_,
          [this](const RobotFigures& figures) { robot_panel_->show(figures); });
  connect(&help_, &HelpPresenter::refused, this,
          [this](const QString& why) { log_.add(LogModel::tr("Refused: %1").arg(why)); });
  connect(images_, &StereoImageView::enlargeWanted, this, &MainWindow::enlargeImages);
  connect(header_, &HeaderBar::imagesWanted, this, &MainWindow::enlargeImages);
  connect(header_, &HeaderBar::calibrationWanted, this, &MainWindow::calibrationWanted);
  connect(header_, &HeaderBar::viewWanted, scene_, &SceneView::resetView);
  connect(header_, &HeaderBar::themeWanted, this, [this] { setDark(!dark_); });
  connect(header_, &HeaderBar::keysWanted, this, [this] { (new ShortcutList(*this))->show(); });
  connect(&alarms_, &AlarmList::raised, this, [this](const Condition& condition) {
    log_.add(tr("Alarm, %1: %2").arg(nameOf(condition.priority), condition.text));
  });
  connect(&report_, &ReportJob::finished, this, [this](const ReportResult& result) {
    log_.add(result.reason.isEmpty() ? tr("Report: %1").arg(result.file)
                                     : tr("No report: %1").arg(result.reason));
  });
  log_.add(workplace_.simulated ? tr("The workstation is ready on the simulated bench")
                                : tr("The workstation is ready"));
}

void MainWindow::setDark(bool dark) {
  dark_ = dark;
  const Theme& theme = dark ? themes_.dark : themes_.light;
  qApp->setStyleSheet(theme.styleSheet());
  rail_->setTheme(theme);
  scene_->setTheme(theme);
  images_->setTheme(theme);
  quality_panel_->setTheme(theme);
  robot_panel_->setTheme(theme);
  alarm_bar_->setTheme(theme);
}

void MainWindow::start() { feed_.start(); }

void MainWindow::present(const station::Snapshot& snapshot, TimePoint now) {
  session_.show(snapshot);
  session_panel_->setChecks(readinessOf(snapshot, workplace_, now));
  session_panel_->setSummary(summaryOf(snapshot.record.measures));
  help_.show(snapshot);
  tracking_.show(snapshot, now);
  robot_.show(snapshot, now);
  journal_.show(snapshot);
  alarms_.update(conditionsOf(snapshot, now));
  header_->show(snapshot.record);
  trace_.add(snapshot);
  if (++beat_ % kBeatsAPlot == 0) quality_panel_->show(trace_);
  images_->show(snapshot.frame);
  if (!images_large_) scene_->show(snapshot);
}

void MainWindow::enlargeImages() {
  images_large_ = !images_large_;
  scene_->setVisible(!images_large_);
  images_->setMinimumHeight(kStrip_px);
  images_->setMaximumHeight(images_large_ ? QWIDGETSIZE_MAX : kStrip_px);
}

}  // namespace mirrorarm::ui
