#include "ui/model/image_overlay.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

struct Overlay {
  Q_DECLARE_TR_FUNCTIONS(Overlay)
};

constexpr double kNearest_m = 0.15, kFarthest_m = 2.5;
constexpr int kLineSteps = 14;

/// What the tracker and the matcher say of the markers of one image.
struct Roles {
  explicit Roles(std::size_t markers) : identities(markers, 0), rivals(markers, 0) {}
  std::vector<int> identities;  ///< number of the taught marker, or 0
  std::vector<char> rivals;     ///< claimed by several pairs
};

std::size_t indexOf(int index) { return static_cast<std::size_t>(index); }

void nameMarkers(const station::TrackedFrame& frame, Roles& left, Roles& right) {
  if (frame.targets.empty()) return;
  const auto& target = frame.targets.front();
  const auto& points = frame.observation.points;
  for (int marker = 0; marker < target.marker_count; ++marker) {
    const int point = target.point_of_marker[indexOf(marker)];
    if (point < 0 || indexOf(point) >= points.size()) continue;
    left.identities[indexOf(points[indexOf(point)].left)] = marker + 1;
    right.identities[indexOf(points[indexOf(point)].right)] = marker + 1;
  }
}

QString labelOf(const ImageOverlay::Mark& mark) {
  QStringList parts;
  if (mark.identity) parts << QString::number(*mark.identity);
  if (mark.cut) parts << Overlay::tr("cut");
  if (mark.ambiguous) parts << QStringLiteral("?");
  return parts.join(QLatin1Char(' '));
}

void addMarks(const vision::Detection& detection, const Roles& roles, ImageOverlay& overlay) {
  for (std::size_t i = 0; i < detection.markers.size(); ++i) {
    const auto& found = detection.markers[i];
    ImageOverlay::Mark mark{found.ellipse, {found.centre_px.x(), found.centre_px.y()}, {}, found.cut, {}, {}};
    if (roles.identities[i] > 0) mark.identity = roles.identities[i];
    mark.ambiguous = !mark.identity && roles.rivals[i] != 0;
    mark.label = labelOf(mark);
    overlay.marks.push_back(std::move(mark));
  }
}

void addRefused(const vision::Detection& detection, ImageOverlay& overlay) {
  for (const auto& light : detection.rejected_lights) {
    const bool speck = light.reason == vision::Rejection::kTooSmall;
    overlay.refused.push_back({{light.position_px.x(), light.position_px.y()},
                               light.extent_px,
                               speck ? QString() : words(light.reason)});
  }
}

// Where the ray of a left pixel lies in the right image: a line through a pinhole, a curve through a fisheye.
std::vector<QPointF> epipolarLine(const camera::StereoRig& rig, const Eigen::Vector2d& left_px) {
  std::vector<QPointF> line;
  const auto ray = rig.left.unproject(left_px);
  for (int step = 0; ray && step <= kLineSteps; ++step) {
    const double inverse_depth =
        1.0 / kFarthest_m + (1.0 / kNearest_m - 1.0 / kFarthest_m) * step / kLineSteps;
    const Eigen::Vector3d p_C = Eigen::Vector3d(ray->x(), ray->y(), 1.0) / inverse_depth;
    const auto pixel = rig.right.project(rig.X_RC * p_C);
    if (pixel) line.emplace_back(pixel->x(), pixel->y());
  }
  return line;
}

/// One line for each left disc that has a partner.
void addLines(const vision::StereoObservation& seen, const Roles& left, const camera::StereoRig& rig,
              ImageOverlay& overlay) {
  std::vector<char> drawn(seen.left.markers.size(), 0);
  for (const auto& point : seen.points) {
    const auto marker = indexOf(point.left);
    if (drawn[marker] != 0) continue;
    drawn[marker] = 1;
    const bool ambiguous = left.identities[marker] == 0 && left.rivals[marker] != 0;
    overlay.epipolar_lines.push_back({epipolarLine(rig, seen.left.markers[marker].centre_px), ambiguous});
  }
}

/// A pair is open while the model has named neither of its discs.
void markRivals(const vision::StereoObservation& seen, Roles& left, Roles& right) {
  for (const auto& point : seen.points) {
    const bool open =
        left.identities[indexOf(point.left)] == 0 && right.identities[indexOf(point.right)] == 0;
    if (point.rivals == 0 || !open) continue;
    left.rivals[indexOf(point.left)] = right.rivals[indexOf(point.right)] = 1;
  }
}

}  // namespace

StereoOverlay overlayOf(const station::TrackedFrame& frame, const camera::StereoRig& rig) {
  const auto& seen = frame.observation;
  Roles left(seen.left.markers.size()), right(seen.right.markers.size());
  nameMarkers(frame, left, right);
  markRivals(seen, left, right);
  StereoOverlay overlay;
  addMarks(seen.left, left, overlay.left);
  addMarks(seen.right, right, overlay.right);
  addRefused(seen.left, overlay.left);
  addRefused(seen.right, overlay.right);
  addLines(seen, left, rig, overlay.right);
  return overlay;
}

}  // namespace mirrorarm::ui
