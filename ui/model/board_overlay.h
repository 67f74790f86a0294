#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QPointF>
#include <QString>

#include "core/camera/stereo_rig.h"
#include "core/station/calibration_snapshot.h"

namespace mirrorarm::ui {

/// What is drawn over one camera image while a board is shown to it, in its raw pixels.
struct BoardOverlay {
  struct Point {
    QPointF centre_px;
    QString label;  ///< the point's number, at the corners of the board
  };
  std::vector<Point> points;
  std::vector<QPointF> outline_px;  ///< along the board's outer points as they are seen
  std::vector<QPointF> wished_px;   ///< the same of the view that is proposed; empty without one
  calibration::Coverage::Grid cells{};
};

/// Left and right. `rig`: what the proposal is drawn by; without one it is not drawn.
[[nodiscard]] std::array<BoardOverlay, 2> boardOverlaysOf(const station::CalibrationSnapshot& snapshot,
                                                          const std::optional<camera::StereoRig>& rig);

}  // namespace mirrorarm::ui
