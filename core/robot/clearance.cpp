#include "core/robot/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace mirrorarm::robot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPostures = 400;       // by which it is judged what is always near
constexpr double kMostly = 0.5;      // of them
constexpr double kNoChange = 1e-18;  // square of a gradient [m^2/rad^2]
constexpr double kHeadLook_m = 1.0;  // farther off no head slows anything

Joints randomPosture(const ArmDescription& arm, std::minstd_rand& random) {
  Joints q(arm.jointCount());
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution<double>(joint.lower_rad, joint.upper_rad)(random);
  }
  return q;
}

}  // namespace

Clearance::Clearance(const ArmDescription& arm, std::span<const Capsule> attached,
                     std::span<const Obstacle> obstacles, const ClearanceSettings& settings)
    : arm_(arm), obstacles_(obstacles.begin(), obstacles.end()), settings_(settings) {
  const auto add = [&](const Capsule& capsule) {
    Shape& shape = shapes_.emplace_back();
    shape.capsule = capsule;
    shape.reach_m = 0.5 * (capsule.b - capsule.a).norm() + capsule.radius_m;
  };
  std::ranges::for_each(arm.shapes, add);
  std::ranges::for_each(attached, add);
  const int shapes = static_cast<int>(shapes_.size());
  const auto linkOf = [&](int shape) { return shapes_[static_cast<std::size_t>(shape)].capsule.link; };
  for (int i = 0; i < shapes; ++i)
    for (int j = i + 1; j < shapes; ++j)
      if (std::abs(linkOf(i) - linkOf(j)) > 1) watched_.push_back({i, j, -1});
  leaveOutWhatIsAlwaysNear();
  for (int i = 0; i < shapes; ++i)
    for (int k = 0; k < static_cast<int>(obstacles_.size()); ++k)
      if (linkOf(i) > 0) watched_.push_back({i, -1, k});
}

void Clearance::leaveOutWhatIsAlwaysNear() {
  std::minstd_rand random(1);
  std::vector<int> near(watched_.size(), 0);
  for (int posture = 0; posture < kPostures; ++posture) {
    place(randomPosture(arm_, random));
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      found_count_ = 0;
      searchSelf(watched_[i]);
      if (found_count_ > 0 && found_[0].distance_m < settings_.self_m) ++near[i];
    }
  }
  std::vector<ClearancePair> kept;
  for (std::size_t i = 0; i < watched_.size(); ++i)
    if (near[i] < kMostly * kPostures) kept.push_back(watched_[i]);
  watched_ = std::move(kept);
}

void Clearance::place(const Joints& q) noexcept {
  RigidTransform X_BL = RigidTransform::Identity();
  int link = 0;
  for (Shape& shape : shapes_) {
    if (shape.capsule.link < link) {  // shapes mostly come in the order of their links
      X_BL.setIdentity();
      link = 0;
    }
    for (; link < shape.capsule.link; ++link) {
      const JointDescription& joint = arm_.joints[static_cast<std::size_t>(link)];
      X_BL = X_BL * joint.X_parent;
      frames_[static_cast<std::size_t>(link)] = {X_BL.linear() * joint.axis, X_BL.translation()};
      X_BL.linear() = X_BL.linear() * Eigen::AngleAxisd(q[link], joint.axis).toRotationMatrix();
    }
    shape.segment = {X_BL * shape.capsule.a, X_BL * shape.capsule.b};
    shape.middle = 0.5 * (shape.segment.a + shape.segment.b);
  }
}

void Clearance::search() noexcept {
  found_count_ = 0;
  for (const ClearancePair& pair : watched_) pair.other >= 0 ? searchSelf(pair) : searchObstacle(pair);
}

void Clearance::searchSelf(const ClearancePair& pair) noexcept {
  const Shape& one = shapes_[static_cast<std::size_t>(pair.shape)];
  const Shape& other = shapes_[static_cast<std::size_t>(pair.other)];
  if ((one.middle - other.middle).norm() - one.reach_m - other.reach_m > settings_.look_m) return;
  const Nearest found = nearest(one.segment, other.segment);
  keep({found.distance_m - one.capsule.radius_m - other.capsule.radius_m, found, pair});
}

void Clearance::searchObstacle(const ClearancePair& pair) noexcept {
  const Shape& shape = shapes_[static_cast<std::size_t>(pair.shape)];
  const Obstacle& obstacle = obstacles_[static_cast<std::size_t>(pair.obstacle)];
  const bool head = obstacle.kind == ObstacleKind::kHead;
  const double look = head ? kHeadLook_m : settings_.look_m;
  const Eigen::Matrix3d& R_BO = obstacle.X_BO.linear();
  const auto inBox = [&](const Eigen::Vector3d& p_B) -> Eigen::Vector3d {
    return R_BO.transpose() * (p_B - obstacle.X_BO.translation());
  };
  const Eigen::Vector3d half = 0.5 * obstacle.size_m, middle = inBox(shape.middle);
  const double far = (middle.cwiseAbs() - half).cwiseMax(0.0).norm() - obstacle.round_m - shape.reach_m;
  if (far > look) return;
  Nearest found = nearestToBox({inBox(shape.segment.a), inBox(shape.segment.b)}, half);
  found.on_first = obstacle.X_BO * found.on_first;
  found.on_second = obstacle.X_BO * found.on_second;
  const double distance = found.distance_m - shape.capsule.radius_m - obstacle.round_m;
  if (head) head_m_ = std::min(head_m_, distance);
  keep({distance, found, pair});
}

void Clearance::keep(const Found& found) noexcept {
  if (found.distance_m > settings_.look_m) return;
  auto* const begin = found_.data();
  auto* const end = begin + found_count_;
  auto* const place = std::ranges::upper_bound(begin, end, found.distance_m, {}, &Found::distance_m);
  if (place == begin + kMostRows) return;
  if (found_count_ < kMostRows) ++found_count_;
  std::move_backward(place, begin + found_count_ - 1, begin + found_count_);
  *place = found;
}

ClearanceRow Clearance::rowOf(const Found& found, bool at_rest) const noexcept {
  ClearanceRow row{found.distance_m, settings_.obstacle_m, Joints::Zero(arm_.jointCount()), at_rest};
  const int link = shapes_[static_cast<std::size_t>(found.pair.shape)].capsule.link;
  int other = 0;
  if (found.pair.other >= 0) {
    row.minimum_m = settings_.self_m;
    other = shapes_[static_cast<std::size_t>(found.pair.other)].capsule.link;
  }
  const double sign = found.nearest.distance_m < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d away = sign * (found.nearest.on_first - found.nearest.on_second).normalized();
  // Joints before both links move both alike. Seen from the other link the arm turns the other way.
  const Eigen::Vector3d& point = link > other ? found.nearest.on_first : found.nearest.on_second;
  const Eigen::Vector3d push = link > other ? away : Eigen::Vector3d(-away);
  for (int j = std::min(link, other); j < std::max(link, other); ++j) {
    const Frame& frame = frames_[static_cast<std::size_t>(j)];
    row.gradient[j] = push.dot(frame.axis.cross(point - frame.origin));
  }
  return row;
}

void Clearance::addRows(bool at_rest) noexcept {
  for (int i = 0; i < found_count_; ++i) {
    const Found& found = found_[static_cast<std::size_t>(i)];
    const ClearanceRow row = rowOf(found, at_rest);
    if (row.gradient.squaredNorm() < kNoChange) continue;
    pairs_[static_cast<std::size_t>(row_count_)] = found.pair;
    rows_[static_cast<std::size_t>(row_count_++)] = row;
  }
}

std::span<const ClearanceRow> Clearance::rows(const Joints& here, const Joints& at_rest) noexcept {
  row_count_ = 0;
  head_m_ = kInfinity;
  for (const Joints* const q : {&here, &at_rest}) {
    place(*q);
    search();
    addRows(q == &at_rest);
  }
  return {rows_.data(), static_cast<std::size_t>(row_count_)};
}

double Clearance::zoneSpeed() const noexcept {
  const double room = head_m_ - settings_.head_near_m, speed = settings_.head_speed_m_s;
  return std::sqrt(speed * speed + 2.0 * settings_.head_braking_m_s2 * std::max(0.0, room));
}

double Clearance::least(const Joints& q) noexcept {
  place(q);
  search();
  return found_count_ > 0 ? found_[0].distance_m : kInfinity;
}

}  // namespace mirrorarm::robot
