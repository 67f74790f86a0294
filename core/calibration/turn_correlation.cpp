#include "core/calibration/turn_correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mirrorarm::calibration {
namespace {

constexpr double kGrid_s = 0.01;
constexpr double kLeastHalfWidth_s = 0.05;
/// A camera's pose that jumps seems to turn faster than the robot ever does.
constexpr double kFasterThanRobot = 1.3;

/// Angular speed on the grid, NaN where the stream has a gap. Value i belongs to time (first + i) * kGrid_s.
struct Speeds {
  long first = 0;
  std::vector<double> rad_s;

  [[nodiscard]] double at(long cell) const {
    const long i = cell - first;
    if (i < 0 || i >= static_cast<long>(rad_s.size())) return std::numeric_limits<double>::quiet_NaN();
    return rad_s[static_cast<std::size_t>(i)];
  }
};

Speeds speedsOf(const TimedPath& path, double half_width_s) {
  Speeds speeds;
  speeds.first = std::lround(std::ceil(path.begin_s() / kGrid_s));
  const long last = std::lround(std::floor(path.end_s() / kGrid_s));
  for (long cell = speeds.first; cell <= last; ++cell) {
    const auto velocity = path.velocityAt(static_cast<double>(cell) * kGrid_s, half_width_s);
    speeds.rad_s.push_back(velocity ? velocity->head<3>().norm() : std::numeric_limits<double>::quiet_NaN());
  }
  return speeds;
}

double fastest(const Speeds& speeds) {
  double most = 0.0;
  for (const double speed : speeds.rad_s)
    if (speed > most) most = speed;
  return most;
}

/// Sums of a correlation.
struct Correlation {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;

  void add(double a, double b) {
    count += 1.0;
    x += a;
    y += b;
    xx += a * a;
    yy += b * b;
    xy += a * b;
  }
  [[nodiscard]] double varianceOfX() const { return std::max(0.0, xx / count - x * x / count / count); }
  [[nodiscard]] double value() const {
    const double variance_y = std::max(0.0, yy / count - y * y / count / count);
    const double both = std::sqrt(varianceOfX() * variance_y);
    return both > 0.0 ? (xy / count - x * y / count / count) / both : 0.0;
  }
};

Correlation correlationAt(const Speeds& robot, const Speeds& camera, long lag) {
  Correlation sums;
  for (std::size_t i = 0; i < camera.rad_s.size(); ++i) {
    const double turned = robot.at(camera.first + static_cast<long>(i) + lag);
    if (!std::isnan(turned) && !std::isnan(camera.rad_s[i])) sums.add(turned, camera.rad_s[i]);
  }
  return sums;
}

/// Top of the parabola through three neighbours, in cells from the middle one.
double parabolaTop(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

/// The highest top that the values fall to from, away from `best`: they must go down first.
double rivalOf(const std::vector<double>& values, std::size_t best) {
  double rival = -1.0;
  for (const int step : {-1, 1}) {
    long i = static_cast<long>(best);
    const auto inside = [&values](long at) { return at >= 0 && at < static_cast<long>(values.size()); };
    const auto value = [&values](long at) { return values[static_cast<std::size_t>(at)]; };
    while (inside(i + step) && value(i + step) <= value(i)) i += step;
    for (; inside(i); i += step)
      if (inside(i + step) && value(i) < value(i + step)) rival = std::max(rival, value(i + step));
  }
  return rival;
}

}  // namespace

TurnCorrelation correlateTurns(const TimedPath& robot_path, const TimedPath& camera_path, double search_s) {
  const double half_width_s =
      std::max({kLeastHalfWidth_s, camera_path.interval_s(), robot_path.interval_s()});
  const Speeds robot = speedsOf(robot_path, half_width_s);
  Speeds camera = speedsOf(camera_path, half_width_s);
  const double limit = kFasterThanRobot * fastest(robot);
  for (double& speed : camera.rad_s)
    if (speed > limit) speed = limit;
  const long reach = std::lround(search_s / kGrid_s);
  std::vector<double> values;
  for (long lag = -reach; lag <= reach; ++lag) {
    const auto sums = correlationAt(robot, camera, lag);
    values.push_back(sums.count > 1.0 ? sums.value() : -1.0);
  }
  const auto best = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const auto lag = static_cast<long>(best) - reach;
  const auto sums = correlationAt(robot, camera, lag);
  TurnCorrelation found;
  found.correlation = values[best];
  found.rival = rivalOf(values, best);
  found.common_s = sums.count * kGrid_s;
  found.speed_std_rad_s = sums.count > 0.0 ? std::sqrt(sums.varianceOfX()) : 0.0;
  const double within = best > 0 && best + 1 < values.size()
                            ? parabolaTop(values[best - 1], values[best], values[best + 1])
                            : 0.0;
  found.offset_s = (static_cast<double>(lag) + within) * kGrid_s;
  return found;
}

}  // namespace mirrorarm::calibration
