#include "core/robot/capsule_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kParallel = 1e-12;  // squared sine of the angle between the segments

Eigen::Vector3d nearestOn(const Segment& segment, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = segment.b - segment.a;
  const double length = way.squaredNorm();
  if (!(length > 0.0)) return segment.a;
  return segment.a + std::clamp((point - segment.a).dot(way) / length, 0.0, 1.0) * way;
}

void keepNearer(Nearest& best, const Eigen::Vector3d& on_first, const Eigen::Vector3d& on_second) {
  const double distance = (on_first - on_second).norm();
  if (distance < best.distance_m) best = {on_first, on_second, distance};
}

/// The nearest points of the two straight lines, where both lie within the segments and the lines cross.
void keepInner(Nearest& best, const Segment& one, const Segment& other) {
  const Eigen::Vector3d u = one.b - one.a, v = other.b - other.a, w = one.a - other.a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > kParallel * uu * vv)) return;
  const double s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
  if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) keepNearer(best, one.a + s * u, other.a + t * v);
}

/// Half the derivative of the squared distance to the box along the segment: it never falls.
double slope(const Segment& segment, const Eigen::Vector3d& way, const Eigen::Vector3d& half, double t) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double x = segment.a[k] + t * way[k];
    sum += way[k] * (x - std::clamp(x, -half[k], half[k]));
  }
  return sum;
}

/// 0, 1 and where the segment enters and leaves the slabs of the box, in order.
struct Crossings {
  std::array<double, 8> t{0.0};
  std::size_t count = 1;

  Crossings(const Segment& segment, const Eigen::Vector3d& way, const Eigen::Vector3d& half) {
    for (int k = 0; k < 3; ++k)
      for (const double side : {-half[k], half[k]}) {
        const double at = (side - segment.a[k]) / way[k];
        if (at > 0.0 && at < 1.0) t[count++] = at;
      }
    t[count++] = 1.0;
    std::sort(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(count));
  }
};

/// Where along the segment the box is nearest; the middle where it is so on a whole stretch.
double nearestShare(const Segment& segment, const Eigen::Vector3d& half) {
  const Eigen::Vector3d way = segment.b - segment.a;
  const Crossings crossings(segment, way, half);
  // Between two crossings the slope is straight.
  double first = 0.0, last = 1.0, before = slope(segment, way, half, 0.0);
  if (before > 0.0) return 0.0;
  bool found = before == 0.0;
  for (std::size_t i = 1; i < crossings.count; ++i) {
    const double from = crossings.t[i - 1], to = crossings.t[i];
    const double after = slope(segment, way, half, to);
    if (!found && after >= 0.0) {
      first = after > before ? from + (to - from) * -before / (after - before) : to;
      found = true;
    }
    if (found && after > 0.0) {
      last = before < 0.0 ? first : from;
      break;
    }
    before = after;
  }
  return found ? 0.5 * (first + last) : 1.0;
}

}  // namespace

Nearest nearest(const Segment& one, const Segment& other) {
  Nearest best{one.a, nearestOn(other, one.a), 0.0};
  best.distance_m = (best.on_first - best.on_second).norm();
  keepNearer(best, one.b, nearestOn(other, one.b));
  keepNearer(best, nearestOn(one, other.a), other.a);
  keepNearer(best, nearestOn(one, other.b), other.b);
  keepInner(best, one, other);
  return best;
}

Nearest nearestToBox(const Segment& segment, const Eigen::Vector3d& half_size) {
  const double t = nearestShare(segment, half_size);
  const Eigen::Vector3d point = segment.a + t * (segment.b - segment.a);
  Eigen::Vector3d on_box = point.cwiseMax(-half_size).cwiseMin(half_size);
  const double distance = (point - on_box).norm();
  if (distance > 0.0) return {point, on_box, distance};
  int axis = 0;
  const double depth = (half_size - point.cwiseAbs()).minCoeff(&axis);
  on_box[axis] = std::copysign(half_size[axis], point[axis]);
  return {point, on_box, -depth};
}

}  // namespace mirrorarm::robot
