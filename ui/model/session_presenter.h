#pragma once

#include <array>
#include <optional>

#include <QObject>
#include <QString>

#include "core/common/time.h"
#include "core/station/station_port.h"

namespace mirrorarm::ui {

/// The five steps that an operator sees, each of one or more phases.
enum class Step { kPrepare, kTeach, kAlign, kTrain, kReport };
inline constexpr int kStepCount = 5;
inline constexpr int kActionCount = 7;  ///< of therapy::Action
[[nodiscard]] Step stepOf(therapy::Phase phase);
[[nodiscard]] QString nameOf(Step step);

/// Everything that the step rail and the session panel show or allow. One value, compared and drawn whole.
struct SessionState {
  Step step = Step::kPrepare;
  therapy::Phase phase = therapy::Phase::kPrepare;
  bool stopped = false;  ///< a stop is latched
  bool can_reset = false;
  bool enabling_needed = false;
  control::EnablingPosition enabling = control::EnablingPosition::kReleased;
  QString title;        ///< of what to do now
  QString instruction;  ///< one or two sentences
  QString progress;     ///< what has come so far; may be empty
  QString message;      ///< why the last wish was refused; empty when it was not
  std::optional<therapy::Action>
      primary;                    ///< the one thing to press; nothing while stopped: then it is reset
  std::array<bool, 8> allowed{};  ///< by therapy::Action
  therapy::Mapping mapping = therapy::Mapping::kFollow;
  bool can_choose_mapping = false;
  std::int64_t session = 0;
  bool can_report = false;     ///< the record is complete
  bool can_calibrate = false;  ///< nothing has begun that needs the devices

  [[nodiscard]] bool allows(therapy::Action action) const {
    return allowed[static_cast<std::size_t>(action)];
  }
  bool operator==(const SessionState&) const = default;
};

/// The session as a sequence of steps: decides what may be pressed and says what to do; draws nothing.
class SessionPresenter : public QObject {
  Q_OBJECT
 public:
  /// `port` outlives the presenter.
  explicit SessionPresenter(station::StationPort& port, QObject* parent = nullptr);

  void show(const station::Snapshot& snapshot);
  [[nodiscard]] const SessionState& state() const { return state_; }

  void ask(therapy::Action action);
  void setMapping(therapy::Mapping mapping);
  /// Past every rule: always goes to the station.
  void stop();
  void resetStop();
  /// Where the enabling key is held; to be said again and again, see station::StationPort.
  void setEnabling(control::EnablingPosition position);

 signals:
  void stateChanged(const mirrorarm::ui::SessionState& state);

 private:
  [[nodiscard]] SessionState stateOf(const station::Snapshot& snapshot) const;
  void hear(const station::ControlState& control);
  void publish(SessionState next);

  station::StationPort& port_;
  SessionState state_;
  QString message_;
  therapy::Mapping mapping_ = therapy::Mapping::kFollow;
  std::uint32_t answers_heard_ = 0;
};

}  // namespace mirrorarm::ui
