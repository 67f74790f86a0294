#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QString>

#include "core/camera/stereo_rig.h"
#include "core/station/snapshot.h"

namespace mirrorarm::ui {

/// What is drawn over one camera image, in its raw pixels.
struct ImageOverlay {
  /// A disc that was found.
  struct Mark {
    vision::Ellipse ellipse;
    QPointF centre_px;
    std::optional<int> identity;  ///< number of the taught marker
    bool cut = false;             ///< something covers a part of it
    bool ambiguous = false;       ///< several partners in the other image, and no model has decided
    QString label;                ///< the number and what is peculiar, in words; may be empty
  };
  /// A light that is no disc.
  struct RefusedLight {
    QPointF centre_px;
    double extent_px = 0.0;
    QString reason;  ///< in words; empty for specks, which are drawn as dots only
  };
  /// Where the partner of a disc of the other image lies.
  struct EpipolarLine {
    std::vector<QPointF> points_px;
    bool ambiguous = false;
  };
  std::vector<Mark> marks;
  std::vector<RefusedLight> refused;
  std::vector<EpipolarLine> epipolar_lines;
};

struct StereoOverlay {
  ImageOverlay left;
  ImageOverlay right;
};

/// What there is to say over the two images of a frame. Discs that the model of the target has named are no
/// longer ambiguous.
[[nodiscard]] StereoOverlay overlayOf(const station::TrackedFrame& frame, const camera::StereoRig& rig);

}  // namespace mirrorarm::ui
