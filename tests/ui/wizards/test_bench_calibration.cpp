#include <functional>

#include <QApplication>
#include <QLabel>
#include <QtTest>
#include <gtest/gtest.h>

#include "tests/station/bench_calibration.h"
#include "ui/wizards/calibration_window.h"

namespace mirrorarm::ui {
namespace {

using station::CalibrationAction;
using station::CalibrationPhase;

/// The wizards' window over the simulated bench, in lockstep. Nothing but keys reaches it.
class BenchWizard : public ::testing::Test {
 protected:
  BenchWizard() {
    window_.resize(1366, 768);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_)) << "keys would not reach it";
  }
  void press(Qt::Key key) {
    QWidget* focused = QApplication::focusWidget();
    QTest::keyClick(focused != nullptr ? focused : &window_, key);
  }
  /// Lets the bench and the screen run until it has come so far.
  bool waitFor(const std::function<bool(const CalibrationState&)>& done) {
    for (int beat = 0; beat < 4000; ++beat) {
      bench_.wait(Seconds(0.1));
      window_.take();
      QCoreApplication::processEvents();
      if (done(state())) return true;
    }
    return false;
  }
  bool waitFor(CalibrationPhase phase) {
    return waitFor([phase](const CalibrationState& s) { return s.phase == phase; });
  }
  /// From the choice to what is in force, as the keys on the buttons say.
  void calibrate() {
    ASSERT_TRUE(waitFor([](const CalibrationState& s) { return s.allows(CalibrationAction::kBegin); }));
    press(Qt::Key_F2);
    ASSERT_TRUE(waitFor([](const CalibrationState& s) {
      return s.phase == CalibrationPhase::kCapturing && s.allows(CalibrationAction::kRemoveView);
    })) << "the first view is taken by itself";
    press(Qt::Key_F5);
    ASSERT_TRUE(waitFor([](const CalibrationState& s) { return s.driving; })) << message();
    ASSERT_TRUE(waitFor([](const CalibrationState& s) { return s.progress_percent == 100 && !s.driving; }))
        << message();
    press(Qt::Key_F6);
    ASSERT_TRUE(waitFor(CalibrationPhase::kSolved)) << state().instruction.toStdString();
    EXPECT_NE(window_.presenter().result().light, Light::kBad);
    press(Qt::Key_F7);
    ASSERT_TRUE(waitFor(CalibrationPhase::kAccepted)) << message();
  }
  [[nodiscard]] const CalibrationState& state() { return window_.presenter().state(); }
  [[nodiscard]] InForceView inForce() const {
    const auto validity = calibration::validityOf(bench_.inForce(), std::chrono::system_clock::now());
    return {standingLines(validity), bench_.inForce().rig};
  }
  [[nodiscard]] std::string message() { return state().message.toStdString(); }

  station::BenchCalibration bench_{{.settings = {.stereo_views = 10, .hand_eye_stations = 8}}};
  CalibrationWindow window_{bench_.station(),
                            {station::kPlate, true},
                            Themes::read(std::filesystem::path(RESOURCES) / "style").value(),
                            [this] { return inForce(); }};
};

TEST_F(BenchWizard, CalibratesCamerasAndHandEyeByKeyboardAlone) {
  calibrate();
  if (HasFatalFailure()) return;
  const auto rig = bench_.inForce().rig;
  ASSERT_TRUE(rig);
  const auto& truth = bench_.bench().rig();
  EXPECT_NEAR(rig->X_RC.translation().norm(), truth.X_RC.translation().norm(), 2e-4);
  EXPECT_NEAR(rig->left.intrinsics().fx_px / truth.left.intrinsics().fx_px, 1.0, 2e-3);
  EXPECT_FALSE(rig->calibration.date.empty());

  EXPECT_EQ(state().job, station::CalibrationJob::kHandEye) << "the next one is proposed";
  calibrate();
  if (HasFatalFailure()) return;
  const auto hand_eye = bench_.inForce().hand_eye;
  ASSERT_TRUE(hand_eye);
  EXPECT_LT((hand_eye->X_PC.translation() - bench_.bench().X_FC().translation()).norm(), 1e-3);
  EXPECT_LT(angleBetween(hand_eye->X_PC, bench_.bench().X_FC()), 0.002);
}

}  // namespace
}  // namespace mirrorarm::ui
