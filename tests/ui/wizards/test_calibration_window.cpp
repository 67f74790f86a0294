#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QSet>
#include <QSpinBox>
#include <QTableView>
#include <QtTest>
#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "tests/ui/fake_calibration.h"
#include "tests/ui/german.h"
#include "ui/model/calibration_words.h"
#include "ui/model/words.h"
#include "ui/panels/stop_button.h"
#include "ui/wizards/calibration_window.h"

namespace mirrorarm::ui {
namespace {

using calibration::CaptureVerdict;
using station::CalibrationAction;
using station::CalibrationJob;
using station::CalibrationPhase;

/// A button that its key presses is seen to go down for a tenth of a second before it acts.
constexpr int kButtonDown_ms = 150;

StandingLines someStanding() {
  return {StandingLine{Light::kBad, QStringLiteral("expired, 120 days old")},
          StandingLine{Light::kGood, QStringLiteral("in force, 3 days old")},
          StandingLine{Light::kOff, QStringLiteral("none so far")},
          StandingLine{Light::kWaiting, QStringLiteral("doubtful, 2 h old")}};
}

class Wizard : public ::testing::Test {
 protected:
  Wizard() {
    window_.resize(1366, 768);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_)) << "keys would not reach it";
    beat();
  }
  void beat() {
    window_.take();
    QCoreApplication::processEvents();
  }
  /// To whatever has the focus, as a keyboard does.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* focused = QApplication::focusWidget();
    QTest::keyClick(focused != nullptr ? focused : &window_, key, modifiers);
    QTest::qWait(kButtonDown_ms);
    beat();
  }
  template <class W = QAbstractButton>
  W* find(const char* name) {
    return window_.findChild<W*>(QLatin1String(name));
  }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
  /// Moves the board about as an engineer does, a view each time.
  void takeViews(int count) {
    for (int i = 0; i < count; ++i)
      port_.take(test::plateAt(0.36 + 0.03 * (i % 4), {0.25 * (i % 3 - 1), 0.3 * (i % 5 - 2), 0.1 * i},
                               {0.05 * (i % 3 - 1), 0.04 * (i % 4 - 1.5), 0}));
    beat();
  }
  /// MIRRORARM_PICTURES names a folder where a person can look at what the tests saw.
  void keep(const QString& name) {
    const auto folder = qEnvironmentVariable("MIRRORARM_PICTURES");
    if (folder.isEmpty()) return;
    for (const bool dark : {false, true}) {
      window_.setDark(dark);
      QCoreApplication::processEvents();
      const QString theme = dark ? QStringLiteral("-dark.png") : QStringLiteral(".png");
      window_.grab().save(QDir(folder).filePath(QStringLiteral("calibrate-") + name + theme));
    }
    window_.setDark(false);
  }

  void check(const char* where) {
    EXPECT_EQ(window_.size(), QSize(1366, 768)) << where << ": the content needs more than the screen has";
    for (const auto* label : window_.findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      const int needed =
          label->wordWrap() ? label->heightForWidth(label->width()) : label->fontMetrics().height();
      EXPECT_GE(label->height(), needed) << where << ": " << label->text().toStdString();
      if (label->wordWrap()) continue;
      EXPECT_LE(label->sizeHint().width(), label->width() + 1)
          << where << ": " << label->text().toStdString();
    }
    for (const auto* button : window_.findChildren<QAbstractButton*>())
      if (button->isVisible() && button->objectName().endsWith(QStringLiteral("Button"))) {
        EXPECT_GE(button->height(), button->minimumSizeHint().height())
            << where << ": " << button->text().toStdString();
        EXPECT_LE(button->mapTo(&window_, QPoint(0, button->height())).y(), 768)
            << button->text().toStdString();
      }
  }
  void expectNothingCutOff() {
    port_.shown.servo.enabling_needed = true;
    check("choose");
    keep(QStringLiteral("choose-") + QLocale().name());
    press(Qt::Key_F2);
    takeViews(9);
    port_.shown.proposal = calibration::ViewWish{test::plateAt(0.3, {0.5, -0.4, 0}), 1.2};
    port_.see(test::plateAt(0.5), CaptureVerdict::kNotNew);
    QTest::qWait(600);
    beat();
    check("capture");
    keep(QStringLiteral("capture-") + QLocale().name());
    press(Qt::Key_Escape);
    check("stopped");
    port_.resetStop();
    takeViews(11);
    press(Qt::Key_F6);
    check("result");
    keep(QStringLiteral("result-") + QLocale().name());
    press(Qt::Key_F7);
    check("in force");
  }

  const camera::StereoRig rig_ = test::benchWorkplace().rig;
  test::FakeCalibration port_{rig_};
  int standing_asked_ = 0;
  CalibrationWindow window_{port_,
                            {test::dotPlate(), true},
                            Themes::read(std::filesystem::path(RESOURCES) / "style").value(),
                            [this] {
                              ++standing_asked_;
                              return InForceView{someStanding(), rig_};
                            }};
};

TEST_F(Wizard, AStereoCalibrationIsDoneByKeyboardAlone) {
  keep(QStringLiteral("1-choose"));
  press(Qt::Key_F2);
  ASSERT_EQ(port_.shown.phase, CalibrationPhase::kCapturing);
  EXPECT_EQ(port_.last_command.job, CalibrationJob::kStereo);
  port_.seeNothing();
  beat();
  keep(QStringLiteral("2-no-board"));
  press(Qt::Key_F4);
  EXPECT_FALSE(port_.shown.automatic);
  port_.see(test::plateAt(0.4), CaptureVerdict::kTake);
  press(Qt::Key_F3);
  ASSERT_EQ(port_.shown.views->size(), 1U);
  takeViews(13);
  port_.shown.proposal = calibration::ViewWish{test::plateAt(0.33, {0.5, -0.3, 0.2}, {0.08, -0.05, 0}), 1.2};
  port_.see(test::plateAt(0.42), CaptureVerdict::kNotNew);
  QTest::qWait(600);  // the words stay that long
  beat();
  keep(QStringLiteral("3-capture"));
  takeViews(6);
  press(Qt::Key_F6);
  ASSERT_EQ(port_.shown.phase, CalibrationPhase::kSolved);
  EXPECT_TRUE(find<QTableView>("resultTable")->isVisible());
  keep(QStringLiteral("4-result"));
  press(Qt::Key_F7);
  ASSERT_EQ(port_.shown.phase, CalibrationPhase::kAccepted);
  EXPECT_EQ(standing_asked_, 2) << "at the start and once it was accepted";
  keep(QStringLiteral("5-in-force"));
  press(Qt::Key_F2);
  EXPECT_EQ(port_.last_command.job, CalibrationJob::kHandEye);
}

TEST_F(Wizard, ViewsAreRemovedAndBroughtBackByKeyboard) {
  press(Qt::Key_F2);
  takeViews(5);
  EXPECT_FALSE(find("removeViewButton")->isEnabled()) << "none is chosen";
  press(Qt::Key_V, Qt::AltModifier);
  auto* table = find<QTableView>("viewTable");
  ASSERT_TRUE(table->hasFocus());
  press(Qt::Key_Down);
  press(Qt::Key_Down);
  const int chosen = table->selectionModel()->currentIndex().row();
  press(Qt::Key_Delete);
  EXPECT_EQ(port_.last_command.action, CalibrationAction::kRemoveView);
  EXPECT_EQ(port_.last_command.view, static_cast<std::size_t>(chosen));
  EXPECT_EQ(table->model()->rowCount(), 4);
  EXPECT_FALSE(find("removeViewButton")->isEnabled());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(table->model()->rowCount(), 5);
  press(Qt::Key_Tab);
  EXPECT_FALSE(table->hasFocus()) << "the tab key leaves the table";
}

TEST_F(Wizard, JobBoardAndLensAreChosenByKeyboard) {
  press(Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(find("driftJob")->isChecked());
  EXPECT_FALSE(find<QComboBox>("lensModel")->isEnabled());
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(find("stereoJob")->isChecked());
  press(Qt::Key_B, Qt::AltModifier);
  press(Qt::Key_Down);
  press(Qt::Key_R, Qt::AltModifier);
  press(Qt::Key_Down);
  press(Qt::Key_L, Qt::AltModifier);
  press(Qt::Key_Down);
  press(Qt::Key_Down);
  press(Qt::Key_F2);
  EXPECT_EQ(port_.last_command.board.kind, calibration::BoardKind::kChessboard);
  EXPECT_EQ(port_.last_command.board.columns, 9);
  EXPECT_EQ(port_.last_command.board.rows, 6);
  EXPECT_NEAR(port_.last_command.board.spacing_m, 0.03, 1e-9);
  EXPECT_EQ(port_.last_command.model, camera::LensModel::kKannalaBrandt);
  EXPECT_FALSE(find<QComboBox>("boardKind")->isEnabled()) << "not while it goes on";
  EXPECT_FALSE(find("clockJob")->isEnabled());
}

TEST_F(Wizard, StopReachesTheRobotInEveryStepFromTheSamePlace) {
  auto* stop = find<StopButton>("stopButton");
  const QPoint place = stop->mapTo(&window_, QPoint());
  const std::vector<std::function<void()>> steps{[] {}, [this] { press(Qt::Key_F2); },
                                                 [this] {
                                                   takeViews(20);
                                                   press(Qt::Key_F6);
                                                 },
                                                 [this] { press(Qt::Key_F7); }};
  int stops = 0;
  for (const auto& step : steps) {
    step();
    EXPECT_TRUE(stop->isVisible() && stop->isEnabled());
    EXPECT_EQ(stop->mapTo(&window_, QPoint()), place);
    EXPECT_GE(stop->height(), StopButton::kSmallestHeight_px);
    QTest::mousePress(stop, Qt::LeftButton);
    EXPECT_EQ(port_.stops, ++stops) << "on pressing down";
    QTest::mouseRelease(stop, Qt::LeftButton);
    port_.resetStop();
    beat();
  }
}

TEST_F(Wizard, AStopWhileDrivingIsResetByKeyboardAndNothingMoves) {
  press(Qt::Key_F2);
  press(Qt::Key_F5);
  ASSERT_TRUE(port_.shown.driving);
  keep(QStringLiteral("6-driving"));
  press(Qt::Key_Escape);
  EXPECT_GE(port_.stops, 1);
  EXPECT_FALSE(find("drivingButton")->isVisible());
  ASSERT_TRUE(find("resetStopButton")->isVisible());
  keep(QStringLiteral("7-stopped"));
  press(Qt::Key_F12);
  EXPECT_EQ(port_.resets, 1);
  EXPECT_TRUE(find("drivingButton")->isVisible());
  EXPECT_FALSE(port_.shown.driving);
}

TEST_F(Wizard, TheEnablingKeyIsHeldWhileTheRobotDrivesAndLettingItGoIsSaid) {
  using control::EnablingPosition;
  press(Qt::Key_F2);
  EXPECT_FALSE(find("enablingButton")->isVisible()) << "not needed";
  port_.shown.servo.enabling_needed = true;
  port_.later = station::CalibrationAnswer::kNotEnabled;
  press(Qt::Key_F5);
  EXPECT_EQ(text("calibrationMessage"), words(station::CalibrationAnswer::kNotEnabled));
  ASSERT_TRUE(find("enablingButton")->isVisible());
  port_.later = station::CalibrationAnswer::kAccepted;
  QTest::keyPress(&window_, Qt::Key_F11);
  EXPECT_EQ(port_.shown.servo.enabling, EnablingPosition::kEnabled);
  press(Qt::Key_F5);
  EXPECT_TRUE(port_.shown.driving);
  keep(QStringLiteral("6-enabled"));
  QTest::keyRelease(&window_, Qt::Key_F11);
  EXPECT_EQ(port_.shown.servo.enabling, EnablingPosition::kReleased);
  port_.stop(control::StopReason::kEnablingReleased);  // as the station does
  beat();
  EXPECT_TRUE(text("guideInstruction").contains(words(control::StopReason::kEnablingReleased)));
  keep(QStringLiteral("7-let-go"));
}

TEST_F(Wizard, ARefusalIsShownWithTheWayBack) {
  press(Qt::Key_F2);
  takeViews(4);
  port_.refusal = "4 views are too few to fix both lenses: 8 and more are needed, tilted in every direction";
  press(Qt::Key_F6);
  EXPECT_TRUE(text("guideInstruction").contains(QStringLiteral("too few")));
  keep(QStringLiteral("8-refused"));
  press(Qt::Key_F8);
  EXPECT_EQ(port_.shown.phase, CalibrationPhase::kCapturing);
  EXPECT_EQ(port_.shown.views->size(), 4U);
}

TEST_F(Wizard, ARefusedWishIsAnsweredBesideTheProgress) {
  press(Qt::Key_F2);
  port_.later = station::CalibrationAnswer::kNoBoard;
  press(Qt::Key_F3);
  EXPECT_TRUE(find<QLabel>("calibrationMessage")->isVisible());
  EXPECT_TRUE(text("calibrationMessage").contains(QStringLiteral("board")));
  EXPECT_TRUE(find<QProgressBar>("progressBar")->isVisible());
}

TEST_F(Wizard, TheWayToTheSessionIsAKey) {
  int wanted = 0;
  QObject::connect(&window_, &CalibrationWindow::sessionWanted, [&wanted] { ++wanted; });
  press(Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(wanted, 1);
}

TEST_F(Wizard, EverythingThatCanBeOperatedHasANameAndAKey) {
  QSet<QString> names, keys;
  for (const auto* button : window_.findChildren<QAbstractButton*>()) {
    if (button->objectName().startsWith(QStringLiteral("qt_"))) continue;  // inside Qt's own widgets
    if (button->parent()->inherits("QTableView")) continue;                // the empty corner of a table
    EXPECT_FALSE(button->objectName().isEmpty()) << button->text().toStdString();
    EXPECT_FALSE(button->accessibleName().isEmpty()) << button->objectName().toStdString();
    EXPECT_FALSE(names.contains(button->objectName())) << button->objectName().toStdString();
    names.insert(button->objectName());
    if (button->objectName() == QStringLiteral("stopButton")) continue;  // Esc, by its own filter
    if (!button->property("heldKey").toString().isEmpty()) continue;     // held, which no shortcut can be
    const QString key = button->shortcut().toString();
    EXPECT_FALSE(key.isEmpty()) << button->objectName().toStdString();
    EXPECT_FALSE(keys.contains(key)) << key.toStdString();
    keys.insert(key);
  }
  for (const char* field : {"boardKind", "boardColumns", "boardRows", "boardStep", "lensModel", "viewTable",
                            "residualTable", "resultTable", "boardImageView", "progressBar"}) {
    ASSERT_NE(find<QWidget>(field), nullptr) << field;
    EXPECT_FALSE(find<QWidget>(field)->accessibleName().isEmpty()) << field;
  }
}

TEST_F(Wizard, NothingIsCutOffOnASmallScreen) { expectNothingCutOff(); }

class GermanWizard : public test::InGerman, public Wizard {};

TEST_F(GermanWizard, IsGermanThroughoutAndNothingIsCutOff) {
  expectNothingCutOff();
  EXPECT_TRUE(test::englishIn(window_).isEmpty()) << test::englishIn(window_).join(" | ").toStdString();
}

TEST_F(Wizard, HandEyeAndDriftShowTheirFigures) {
  station::HandEyeOutcome hand_eye;
  hand_eye.result.X_PC = test::benchWorkplace().X_FC;
  hand_eye.result.rms_m = 0.00021;
  hand_eye.result.rms_rad = 0.0004;
  hand_eye.result.sigma_m = 0.00003;
  hand_eye.result.stations.resize(15);
  hand_eye.result.outliers = {3};
  hand_eye.shift_mm = 0.82;
  hand_eye.turn_deg = 0.041;
  port_.outcome = std::make_shared<station::CalibrationOutcome>(hand_eye);
  press(Qt::Key_2, Qt::ControlModifier);
  press(Qt::Key_F2);
  takeViews(15);
  auto views = *port_.shown.views;
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i].residual_m = 0.0001 + 0.00001 * static_cast<double>(i);
  views[3].residual_m = 0.0512;
  views[3].is_outlier = true;
  port_.shown.views = std::make_shared<const std::vector<station::TakenView>>(views);
  press(Qt::Key_F6);
  keep(QStringLiteral("9-hand-eye"));
  EXPECT_EQ(find<QTableView>("residualTable")->model()->rowCount(), 15);
  EXPECT_GT(find<QTableView>("resultTable")->model()->rowCount(), 8);
}

}  // namespace
}  // namespace mirrorarm::ui
