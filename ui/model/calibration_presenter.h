#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QVector>

#include "core/common/time.h"
#include "core/station/calibration_port.h"
#include "ui/model/calibration_result.h"
#include "ui/model/capture_lights.h"

namespace mirrorarm::ui {

/// The steps of every calibration.
enum class CalibrationStep { kChoose, kCapture, kSolve, kResult };
inline constexpr int kCalibrationStepCount = 4;
inline constexpr std::size_t kCalibrationActionCount = 10;  ///< of station::CalibrationAction
[[nodiscard]] CalibrationStep stepOf(station::CalibrationPhase phase);
[[nodiscard]] QString nameOf(CalibrationStep step);

/// Everything that the wizard's frame shows or allows. One value, compared and drawn whole.
struct CalibrationState {
  CalibrationStep step = CalibrationStep::kChoose;
  station::CalibrationPhase phase = station::CalibrationPhase::kIdle;
  station::CalibrationJob job = station::CalibrationJob::kStereo;  ///< chosen, or going on
  bool can_choose = true;                                          ///< job, board and lens model
  bool stopped = false;                                            ///< a stop is latched
  bool can_reset = false;
  bool enabling_needed = false;
  control::EnablingPosition enabling = control::EnablingPosition::kReleased;
  QString title;  ///< of what to do now
  QString instruction;
  QString message;  ///< why the last wish was refused; empty when it was not
  std::optional<station::CalibrationAction> primary;    ///< the one thing to press
  std::array<bool, kCalibrationActionCount> allowed{};  ///< by station::CalibrationAction
  bool automatic = true;
  bool driving = false;
  int progress_percent = 0;
  QVector<QualityLight> lights;  ///< while capturing

  [[nodiscard]] bool allows(station::CalibrationAction action) const {
    return allowed[static_cast<std::size_t>(action)];
  }
  bool operator==(const CalibrationState&) const = default;
};

/// A calibration as a sequence of steps: decides what may be pressed and says what to do; draws nothing.
class CalibrationPresenter : public QObject {
  Q_OBJECT
 public:
  /// `port` outlives the presenter; `board` is the one proposed.
  CalibrationPresenter(station::CalibrationPort& port, const calibration::Board& board,
                       QObject* parent = nullptr);

  void show(const station::CalibrationSnapshot& snapshot, TimePoint now);
  [[nodiscard]] const CalibrationState& state() const { return state_; }
  [[nodiscard]] const CalibrationResult& result() const { return result_; }
  [[nodiscard]] const calibration::Board& board() const { return wish_.board; }

  // What begins next; taken while `can_choose`.
  void choose(station::CalibrationJob job);
  void setBoard(const calibration::Board& board) { wish_.board = board; }
  /// Nothing: the one with the smaller error on views kept out.
  void setModel(std::optional<camera::LensModel> model) { wish_.model = model; }

  void ask(station::CalibrationAction action);
  void setAutomatic(bool on);
  void setDriving(bool on);
  void removeView(std::size_t view);
  /// Past every rule: always goes to the station.
  void stop();
  void resetStop();
  /// Where the enabling key is held; to be said again and again, see station::CalibrationPort.
  void setEnabling(control::EnablingPosition position);

 signals:
  void stateChanged(const mirrorarm::ui::CalibrationState& state);
  void resultChanged(const mirrorarm::ui::CalibrationResult& result);

 private:
  [[nodiscard]] CalibrationState stateOf(const station::CalibrationSnapshot& snapshot) const;
  void hear(const station::CalibrationSnapshot& snapshot);
  void judge(const station::CalibrationSnapshot& snapshot);
  void send(const station::CalibrationCommand& command);
  void publish(CalibrationState next);

  station::CalibrationPort& port_;
  station::CalibrationCommand wish_;  ///< job, board and model of the next begin
  CalibrationState state_;
  CalibrationResult result_;
  std::shared_ptr<const station::CalibrationOutcome> judged_;
  QString message_;
  std::uint32_t answers_heard_ = 0;
  TimePoint worded_at_{};
};

}  // namespace mirrorarm::ui
