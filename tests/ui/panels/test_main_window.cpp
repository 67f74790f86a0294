#include <QAbstractButton>
#include <QDir>
#include <QFontMetrics>
#include <QFrame>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QSet>
#include <QtTest>
#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "tests/ui/german.h"
#include "ui/panels/main_window.h"
#include "ui/panels/quality_panel.h"
#include "ui/panels/stop_button.h"
#include "ui/views/scene_view.h"

namespace mirrorarm::ui {
namespace {

using therapy::Phase;

const std::vector<Phase> kPhases{Phase::kPrepare,  Phase::kTeaching, Phase::kTaught,  Phase::kAligned,
                                 Phase::kTraining, Phase::kPaused,   Phase::kFinished};

class Window : public ::testing::Test {
 protected:
  Window() {
    window_.resize(1366, 768);
    window_.show();
    beat();
  }
  void beat() { window_.feed().take(); }
  void enter(Phase phase) {
    station_.enter(phase);
    beat();
    QCoreApplication::processEvents();
  }
  template <class W = QAbstractButton>
  W* find(const char* name) {
    return window_.findChild<W*>(QLatin1String(name));
  }
  void expectCardsHold() {
    for (const auto* card : window_.findChildren<QFrame*>())
      if (card->isVisible() && card->property("card").toBool()) {
        EXPECT_GE(card->height(), card->minimumSizeHint().height()) << card->objectName().toStdString();
      }
  }
  void expectNothingCutOff() {
    auto& measures = station_.shown.record.measures;
    measures.force_share = measures.help_adapting_share = 1.0;
    measures.help_level = 0.5;
    for (const auto phase : kPhases) {
      station_.shown.control.servo.assist.gives_way = phase == Phase::kTraining;
      enter(phase);
      EXPECT_EQ(window_.size(), QSize(1366, 768)) << "the content needs more than the screen has";
      for (const auto* label : window_.findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty()) continue;
        EXPECT_GE(label->height(), label->fontMetrics().height()) << label->text().toStdString();
        if (label->wordWrap()) continue;
        EXPECT_LE(label->sizeHint().width(), label->width() + 1) << label->text().toStdString();
      }
      expectCardsHold();
      keep(QStringLiteral("phase-%1-%2.png").arg(static_cast<int>(phase)).arg(QLocale().name()));
    }
  }
  QImage picture() { return window_.grab().toImage(); }
  /// MIRRORARM_PICTURES names a folder where a person can look at what the tests saw.
  void keep(const QString& name) {
    const auto folder = qEnvironmentVariable("MIRRORARM_PICTURES");
    if (!folder.isEmpty()) picture().save(QDir(folder).filePath(name));
  }

  Workplace workplace_ = test::benchWorkplace();
  test::FakeStation station_{workplace_};
  MainWindow window_{station_, workplace_, Themes::read(std::filesystem::path(RESOURCES) / "style").value(),
                     [](std::int64_t) -> Expected<ReportJob::Draw, QString> {
                       return unexpected(QStringLiteral("there is no store"));
                     }};
};

TEST_F(Window, StopReachesTheStationWhilePressedInEveryPhase) {
  auto* stop = find<StopButton>("stopButton");
  ASSERT_NE(stop, nullptr);
  const QPoint place = stop->mapTo(&window_, QPoint());
  int stops = 0;
  for (const auto phase : kPhases) {
    enter(phase);
    EXPECT_TRUE(stop->isEnabled());
    EXPECT_TRUE(stop->isVisible());
    EXPECT_EQ(stop->mapTo(&window_, QPoint()), place) << "always in the same place";
    EXPECT_GE(stop->height(), 64);
    QTest::mousePress(stop, Qt::LeftButton);
    EXPECT_EQ(station_.stops, ++stops) << "on pressing down, before it is let go";
    QTest::mouseRelease(stop, Qt::LeftButton);
    EXPECT_EQ(station_.stops, stops);
    station_.resetStop();
  }
}

TEST_F(Window, TheEscapeKeyStopsWhereverTheFocusIs) {
  int stops = 0;
  for (const char* name : {"sceneView", "stereoImageView", "logLines", "themeButton"}) {
    auto* widget = find<QWidget>(name);
    ASSERT_NE(widget, nullptr) << name;
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_Escape);
    EXPECT_GT(station_.stops, stops) << name;
    stops = station_.stops;
  }
}

TEST_F(Window, ALatchedStopOffersItsResetAndNothingThatMoves) {
  enter(Phase::kTraining);
  QTest::mouseClick(find("stopButton"), Qt::LeftButton);
  beat();
  EXPECT_TRUE(find("resetStopButton")->isVisible());
  EXPECT_FALSE(find("startButton")->isVisible());
  EXPECT_TRUE(find("stopButton")->isEnabled());
  keep(QStringLiteral("stopped.png"));
  find("resetStopButton")->click();
  EXPECT_EQ(station_.resets, 1);
  beat();
  EXPECT_EQ(station_.shown.control.phase, Phase::kPaused);
  EXPECT_TRUE(find("startButton")->isVisible());
}

TEST_F(Window, AStopThatCannotBeResetYetKeepsItsButtonFromBeingPressed) {
  enter(Phase::kTraining);
  QTest::mouseClick(find("stopButton"), Qt::LeftButton);
  station_.shown.control.servo.reset = control::ResetRefusal::kMoving;
  beat();
  EXPECT_TRUE(find("resetStopButton")->isVisible());
  EXPECT_FALSE(find("resetStopButton")->isEnabled());
  EXPECT_FALSE(find<QLabel>("stepMessage")->text().isEmpty());
  keep(QStringLiteral("stopped-moving.png"));
}

TEST_F(Window, TheEnablingKeyHasThreePositionsAndIsReleasedWithTheWindow) {
  using control::EnablingPosition;
  EXPECT_FALSE(find("enablingButton")->isVisible()) << "not needed";
  station_.shown.control.servo.enabling_needed = true;
  enter(Phase::kAligned);
  ASSERT_TRUE(find("enablingButton")->isVisible());
  keep(QStringLiteral("enabling.png"));
  const auto& position = station_.shown.control.servo.enabling;
  auto* scene = find<QWidget>("sceneView");
  QTest::keyPress(scene, Qt::Key_F11);
  EXPECT_EQ(position, EnablingPosition::kEnabled) << "wherever the focus is";
  beat();
  keep(QStringLiteral("enabled.png"));
  QTest::keyPress(scene, Qt::Key_Pause);
  EXPECT_EQ(position, EnablingPosition::kPressedThrough);
  QTest::keyRelease(scene, Qt::Key_Pause);
  QTest::keyRelease(scene, Qt::Key_F11);
  EXPECT_EQ(position, EnablingPosition::kReleased);
  QTest::mousePress(find("enablingButton"), Qt::LeftButton);
  EXPECT_EQ(position, EnablingPosition::kEnabled);
  QEvent left(QEvent::WindowDeactivate);
  QCoreApplication::sendEvent(&window_, &left);
  EXPECT_EQ(position, EnablingPosition::kReleased);
}

TEST_F(Window, HelpIsChosenByMouseAndKeysAndNotWhereTheRobotIsStiff) {
  enter(Phase::kTraining);
  auto* reason = find<QLabel>("helpReason");
  EXPECT_FALSE(find("helpAdaptsButton")->isEnabled());
  EXPECT_FALSE(find("moreHelpButton")->isVisible());
  EXPECT_TRUE(reason->isVisible() && !reason->text().isEmpty());
  keep(QStringLiteral("help-stiff.png"));
  auto& control = station_.shown.control;
  control.servo.assist.gives_way = true;
  beat();
  EXPECT_FALSE(reason->isVisible());
  find("lessHelpButton")->click();
  EXPECT_EQ(control.help, (control::Help{false, 0.9}));
  beat();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_)) << "keys would not reach it";
  const auto press = [this](Qt::Key key) {
    QTest::keyClick(&window_, key, Qt::ControlModifier);
    QTest::qWait(150);  // the button is seen to go down before it acts
  };
  press(Qt::Key_Down);
  EXPECT_EQ(control.help, (control::Help{false, 0.8}));
  beat();
  EXPECT_EQ(find<QLabel>("helpLevel")->text(), QStringLiteral("80 %"));
  keep(QStringLiteral("help-fixed.png"));
  press(Qt::Key_H);
  EXPECT_TRUE(control.help.adapts);
  beat();
  EXPECT_TRUE(find("helpAdaptsButton")->isChecked());
  EXPECT_FALSE(find("moreHelpButton")->isEnabled());
  for (const bool dark : {false, true}) {
    window_.setDark(dark);
    QCoreApplication::processEvents();
    keep(dark ? QStringLiteral("help-adapts-dark.png") : QStringLiteral("help-adapts.png"));
  }
}

TEST_F(Window, TheButtonsLeadThroughASession) {
  for (const char* name :
       {"teachButton", "keepMarkersButton", "alignButton", "startButton", "pauseButton", "finishButton"}) {
    auto* button = find(name);
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isVisible()) << name;
    ASSERT_TRUE(button->isEnabled()) << name;
    keep(QString::fromLatin1(name) + QStringLiteral(".png"));
    button->click();
    beat();
    QCoreApplication::processEvents();
  }
  EXPECT_EQ(station_.shown.control.phase, Phase::kFinished);
  EXPECT_TRUE(find("makeReportButton")->isVisible());
}

TEST_F(Window, AFailedReportSaysWhy) {
  enter(Phase::kFinished);
  find("makeReportButton")->click();
  auto* result = find<QLabel>("reportResult");
  ASSERT_TRUE(QTest::qWaitFor([&] { return result->text().contains(QStringLiteral("no store")); }, 5000));
  EXPECT_FALSE(find("openReportButton")->isVisible());
}

TEST_F(Window, EverythingThatCanBeOperatedHasANameAndAKey) {
  QSet<QString> names, keys;
  for (const auto* button : window_.findChildren<QAbstractButton*>()) {
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
}

TEST_F(Window, NothingIsCutOffOnASmallScreen) { expectNothingCutOff(); }

class GermanWindow : public test::InGerman, public Window {};

TEST_F(GermanWindow, IsGermanThroughoutAndNothingIsCutOff) {
  expectNothingCutOff();
  for (const auto phase : kPhases) {
    enter(phase);
    EXPECT_TRUE(test::englishIn(window_).isEmpty()) << test::englishIn(window_).join(" | ").toStdString();
  }
  station_.stop(control::StopReason::kForce);
  beat();
  QCoreApplication::processEvents();
  EXPECT_TRUE(test::englishIn(window_).isEmpty()) << test::englishIn(window_).join(" | ").toStdString();
  keep(QStringLiteral("german-stopped.png"));
}

TEST_F(Window, TheSceneIsDrawn) {
  enter(Phase::kTraining);
  const auto* scene = find<SceneView>("sceneView");
  const QImage drawn = picture().copy(QRect(scene->mapTo(&window_, QPoint()), scene->size()));
  QSet<QRgb> colours;
  for (int y = 0; y < drawn.height(); y += 3)
    for (int x = 0; x < drawn.width(); x += 3) colours.insert(drawn.pixel(x, y));
  EXPECT_GT(colours.size(), 300) << "shaded bodies before a gradient";
}

TEST_F(Window, TheSimulationMarkIsPermanent) {
  for (const auto phase : kPhases) {
    enter(phase);
    ASSERT_NE(find<QLabel>("simulationMark"), nullptr);
    EXPECT_TRUE(find<QLabel>("simulationMark")->isVisible());
  }
}

TEST_F(Window, TheImagesCanBeEnlargedAndPutBack) {
  enter(Phase::kTraining);
  auto* images = find<QWidget>("stereoImageView");
  const int small = images->height();
  QTest::mouseClick(images, Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_GT(images->height(), 2 * small);
  keep(QStringLiteral("images.png"));
  find("imagesButton")->click();
  QCoreApplication::processEvents();
  EXPECT_EQ(images->height(), small);
}

TEST_F(Window, RefusedLightsAreShownUntilTheyAreHidden) {
  enter(Phase::kTraining);
  station_.clutter();
  beat();
  for (const bool dark : {false, true}) {
    window_.setDark(dark);
    QCoreApplication::processEvents();
    keep(dark ? QStringLiteral("clutter-strip-dark.png") : QStringLiteral("clutter-strip.png"));
  }
  find("imagesButton")->click();
  QCoreApplication::processEvents();
  auto* images = find<QWidget>("stereoImageView");
  const QImage shown = images->grab().toImage();
  keep(QStringLiteral("clutter.png"));
  find("refusedLightsButton")->click();
  QCoreApplication::processEvents();
  EXPECT_NE(images->grab().toImage(), shown);
  keep(QStringLiteral("clutter-hidden.png"));
  find("refusedLightsButton")->click();
  QCoreApplication::processEvents();
  EXPECT_EQ(images->grab().toImage(), shown);
}

TEST_F(Window, WarningsOfBothCamerasFitASmallScreen) {
  auto warned = std::make_shared<station::TrackedFrame>(*station_.shown.frame);
  warned->observation.left.exposure.warning = vision::ExposureWarning::kTooDark;
  warned->observation.right.exposure.warning = vision::ExposureWarning::kBrightBackground;
  TrackingPresenter presenter;
  presenter.show({warned, {}, {}}, warned->frame.exposed_at);
  auto* panel = find<QualityPanel>("qualityPanel");
  panel->show(presenter.state());
  QCoreApplication::processEvents();
  EXPECT_EQ(window_.size(), QSize(1366, 768));
  for (const auto* label : panel->findChildren<QLabel*>())
    if (label->isVisible() && !label->text().contains(QLatin1Char('<'))) {
      EXPECT_LE(label->sizeHint().width(), label->width()) << label->text().toStdString();
    }
  const auto* plot = find<QWidget>("motionPlot");
  EXPECT_GE(plot->height(), plot->minimumHeight());
  EXPECT_LE(plot->mapTo(panel, QPoint(0, plot->height())).y(), panel->height()) << "cut off below";
  expectCardsHold();
  keep(QStringLiteral("warnings.png"));
}

}  // namespace
}  // namespace mirrorarm::ui
