#include "core/therapy/exercise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::therapy {
namespace {

using Leg = Exercise::Leg;

// Out and back along a straight line. Minimum jerk peaks at 1.875 times the mean speed: 75 mm/s here, half of
// what the robot's joint limits leave to the tool.
Exercise outAndBack(const std::string& id, const Eigen::Vector3d& displacement_m) {
  return {id, {Leg{displacement_m, 0.0, 2.5, 0.5}, Leg{Eigen::Vector3d::Zero(), 0.0, 2.5, 0.5}}};
}

// Upright circle in front of the body, begun at its lowest point.
Exercise circle() {
  constexpr int kChords = 8;
  constexpr double kRadius_m = 0.05;
  Exercise exercise{"circle", {}};
  for (int i = 1; i <= kChords; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kChords;
    const Eigen::Vector3d point(0.0, kRadius_m * std::sin(angle), kRadius_m * (1.0 - std::cos(angle)));
    exercise.legs.push_back({i < kChords ? point : Eigen::Vector3d::Zero().eval(), 0.0, 1.0, 0.0});
  }
  exercise.legs.back().rest_s = 0.5;
  return exercise;
}

// Slow enough that a wrist joint of 0.24 rad/s keeps up: the peak is 0.19 rad/s.
Exercise turn() {
  Exercise exercise{"turn", {}};
  for (const double angle_rad : {0.4, 0.0, -0.4, 0.0})
    exercise.legs.push_back({Eigen::Vector3d::Zero(), angle_rad, 4.0, 0.5});
  return exercise;
}

}  // namespace

const std::vector<Exercise>& exercises() {
  static const std::vector<Exercise> catalogue{outAndBack("reach", {-0.10, 0.0, 0.0}),
                                               outAndBack("lift", {0.0, 0.0, 0.10}),
                                               outAndBack("side", {0.0, 0.10, 0.0}), circle(), turn()};
  return catalogue;
}

std::optional<Exercise> exerciseOf(std::string_view id) {
  const auto found = std::ranges::find(exercises(), id, &Exercise::id);
  if (found == exercises().end()) return std::nullopt;
  return *found;
}

}  // namespace mirrorarm::therapy
