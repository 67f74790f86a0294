#pragma once

#include <QObject>
#include <QString>
#include <QVector>

#include "core/common/time.h"
#include "core/station/snapshot.h"
#include "ui/model/light.h"

namespace mirrorarm::ui {

/// A line on how the images are lit.
struct ExposureLine {
  bool warns = false;
  QString text;  ///< which camera, what is wrong with its light and what to do
  bool operator==(const ExposureLine&) const = default;
};

/// What the tracking figures are right now. One value, compared and drawn whole; figures change a few times a
/// second so that they can be read, the light at once.
struct TrackingState {
  Light light = Light::kOff;
  QString status;   ///< one word or two: "Tracked", "Lost", "Not taught"
  QString detail;   ///< why; may be empty
  QString markers;  ///< found of taught
  QString misfit;   ///< rms of the rigid fit
  QString age;      ///< of the newest pose
  QString vision;   ///< computing time of a frame
  QString lost_frames;
  QString refused;                 ///< lights of both images that are no markers, without the specks
  QString refused_reasons;         ///< how many for which reason, a line a camera; empty for none
  QVector<ExposureLine> exposure;  ///< one while both images are well lit, else a line a camera
  QString accessible;              ///< the whole in one sentence
  bool operator==(const TrackingState&) const = default;
};

/// Says how well the healthy arm is seen.
class TrackingPresenter : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  void show(const station::Snapshot& snapshot, TimePoint now);
  [[nodiscard]] const TrackingState& state() const { return state_; }

 signals:
  void stateChanged(const mirrorarm::ui::TrackingState& state);

 private:
  TrackingState state_;
  TimePoint figures_at_{};
};

}  // namespace mirrorarm::ui
