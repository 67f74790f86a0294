#pragma once

#include <QString>
#include <QVector>

#include "core/station/calibration_snapshot.h"
#include "ui/model/light.h"

namespace mirrorarm::ui {

/// One thing that a good calibration needs, and how it stands.
struct QualityLight {
  Light light = Light::kOff;
  QString text;   ///< "Seen by the left camera"
  QString value;  ///< "63 of 63"; may be empty
  bool operator==(const QualityLight&) const = default;
};

/// What is good and what is wanting, of the view before the cameras and of the views so far. Shares are good
/// from 70 % on, as in the ROS camera calibrator.
[[nodiscard]] QVector<QualityLight> captureLights(const station::CalibrationSnapshot& snapshot);

}  // namespace mirrorarm::ui
