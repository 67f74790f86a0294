#include "core/robot/clearance.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoChange = 1e-18;       // square of a gradient [m^2/rad^2]
constexpr double kHeadLook_m = 1.0;       // farther off no head slows anything
constexpr double kFastestHand_m_s = 0.5;  // no profile lets it go so fast

}  // namespace

Clearance::Clearance(const ArmDescription& arm, std::span<const Capsule> attached,
                     std::span<const Obstacle> obstacles, const ClearanceSettings& settings)
    : shapes_(arm, attached, obstacles, settings.keep), settings_(settings) {}

bool Clearance::isHead(const ShapePair& pair) const noexcept {
  return pair.obstacle >= 0 && shapes_.obstacle(pair.obstacle).kind == ObstacleKind::kHead;
}

void Clearance::search() noexcept {
  found_count_ = 0;
  for (const ShapePair& pair : shapes_.pairs()) {
    const bool head = isHead(pair);
    if (shapes_.atLeast(pair) > (head ? kHeadLook_m : settings_.look_m)) continue;
    const Gap gap = shapes_.gap(pair);
    if (head) head_m_ = std::min(head_m_, gap.distance_m);
    if (gap.distance_m <= settings_.look_m) keep({pair, gap});
  }
}

void Clearance::keep(const Found& found) noexcept {
  auto* const begin = found_.data();
  auto* const end = begin + found_count_;
  auto* const place = std::ranges::upper_bound(begin, end, found.room_m(), {}, &Found::room_m);
  if (place == begin + kMostRows) return;
  if (found_count_ < kMostRows) ++found_count_;
  std::move_backward(place, begin + found_count_ - 1, begin + found_count_);
  *place = found;
}

ClearanceRow Clearance::rowOf(const Found& found, bool at_rest) const noexcept {
  const auto& [pair, gap] = found;
  ClearanceRow row{gap.distance_m, pair.keep_m, Joints::Zero(shapes_.arm().jointCount()), at_rest};
  // Joints before both links move both alike.
  const int first = pair.other >= 0 ? shapes_.capsule(pair.other).link : 0;
  for (int j = first; j < shapes_.capsule(pair.shape).link; ++j) {
    const auto& [axis, origin] = shapes_.axis(j);
    row.gradient[j] = gap.away.dot(axis.cross(gap.on_shape - origin));
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
    shapes_.place(*q);
    search();
    if (q == &here) noteHand();
    addRows(q == &at_rest);
  }
  return {rows_.data(), static_cast<std::size_t>(row_count_)};
}

void Clearance::noteHand() noexcept {
  hand_count_ = 0;
  if (zoneSpeed() >= kFastestHand_m_s) return;
  for (int shape = 0; shape < shapes_.count(); ++shape) {
    const Capsule& capsule = shapes_.capsule(shape);
    if (capsule.part == ArmPart::kLink || hand_count_ + 2 > kMostHandPoints) continue;
    const Segment& axis = shapes_.segment(shape);
    const Eigen::Vector3d beyond = capsule.radius_m * (axis.b - axis.a).normalized();
    for (const Eigen::Vector3d& end : {Eigen::Vector3d(axis.a - beyond), Eigen::Vector3d(axis.b + beyond)})
      hand_[static_cast<std::size_t>(hand_count_++)] = jacobianOf(end);
  }
}

Jacobian Clearance::jacobianOf(const Eigen::Vector3d& p_B) const noexcept {
  Jacobian jacobian(6, shapes_.arm().jointCount());
  for (int j = 0; j < shapes_.arm().jointCount(); ++j) {
    const auto& [axis, origin] = shapes_.axis(j);
    jacobian.col(j) << axis.cross(p_B - origin), axis;
  }
  return jacobian;
}

std::span<const Jacobian> Clearance::hand() const noexcept {
  return {hand_.data(), static_cast<std::size_t>(hand_count_)};
}

double Clearance::zoneSpeed() const noexcept {
  const double room = head_m_ - settings_.head_near_m, speed = settings_.head_speed_m_s;
  return std::sqrt(speed * speed + 2.0 * settings_.head_braking_m_s2 * std::max(0.0, room));
}

double Clearance::leastRoom(const Joints& q) noexcept {
  shapes_.place(q);
  search();
  return found_count_ > 0 ? found_[0].room_m() : kInfinity;
}

}  // namespace mirrorarm::robot
