#pragma once

#include <QObject>
#include <QString>

#include "core/station/station_port.h"

namespace mirrorarm::ui {

/// What the choice of help shows and allows. One value, compared and drawn whole.
struct HelpState {
  bool can_change = false;
  bool can_lessen = false;
  bool can_raise = false;
  bool adapts = false;
  QString level;   ///< that is wanted; a dash while it adapts
  QString reason;  ///< why nothing can be chosen, in a word; empty where it can
  bool operator==(const HelpState&) const = default;
};

/// How much the robot is to help: adapting to the patient, or fixed at a level in steps of ten percent.
class HelpPresenter : public QObject {
  Q_OBJECT
 public:
  /// `port` outlives the presenter.
  explicit HelpPresenter(station::StationPort& port, QObject* parent = nullptr);

  void show(const station::Snapshot& snapshot);
  [[nodiscard]] const HelpState& state() const { return state_; }

  /// Off: the help stays at the level where it is.
  void setAdapts(bool on);
  void lessen();
  void raise();

 signals:
  void stateChanged(const mirrorarm::ui::HelpState& state);
  /// The station takes no wishes now.
  void refused(const QString& why);

 private:
  [[nodiscard]] HelpState stateOf() const;
  void ask(const control::Help& help);

  station::StationPort& port_;
  control::Help wanted_;
  control::AssistState given_;
  HelpState state_;
};

}  // namespace mirrorarm::ui
