#include "core/robot/posture_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/robot/posture_comfort.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPi = std::numbers::pi;

// How far the arm angle may be drawn in one answer: always a little, and more the further the wrist goes.
constexpr double kDraw_rad = 0.002, kDrawPerTravel = 2.0, kDrawPerTurn = 0.5, kLargestDraw_rad = 0.1;
// What still counts as near the seed: no joint further than this.
constexpr double kNear_rad = 0.25, kNearPerTravel = 4.0, kNearPerTurn = 2.0;

constexpr double kAlignedSine = 1e-9;  // only the sum of the joints on both sides is known
constexpr double kRoundOff = 1e-10;
constexpr double kInside_rad = 1e-6;  // from the end of a range of arm angles

/// How far the wrist goes between two poses.
struct Travel {
  double metres = 0.0;
  double turn_rad = 0.0;
  [[nodiscard]] double times(double least, double per_metre, double per_radian) const {
    return least + per_metre * metres + per_radian * turn_rad;
  }
};

double farthest(const Joints& q, const Joints& seed) { return (q - seed).cwiseAbs().maxCoeff(); }

/// Of two joints that turn about one line only the sum is known: the first stays where the seed has it.
void keepTurns(Joints& q, const Joints& seed, const SrsArm& arm) {
  for (const int middle : {1, 5}) {
    if (std::abs(std::sin(q[middle])) > kAlignedSine) continue;
    const auto before = static_cast<std::size_t>(middle - 1), after = static_cast<std::size_t>(middle + 1);
    const double turn = seed[middle - 1] - q[middle - 1];
    q[middle - 1] += turn;
    q[middle + 1] = std::remainder(q[middle + 1] - arm.sign[before] * arm.sign[after] * turn, 2.0 * kPi);
  }
}

/// The postures of one pose as seen from a seed.
class Question {
 public:
  Question(const SrsArm& arm, const JointRanges& ranges, const SrsPostures& postures, const Joints& seed)
      : arm_(arm), ranges_(ranges), postures_(postures), seed_(seed), seed_wrist_(srsWrist(arm, seed)) {}

  /// Branch and arm angle of the seed, drawn towards comfort.
  [[nodiscard]] Joints continued(const RigidTransform& X_UW) {
    const Travel travel{(X_UW.translation() - seed_wrist_.X_UW.translation()).norm(),
                        angleBetween(X_UW, seed_wrist_.X_UW)};
    near_rad_ = travel.times(kNear_rad, kNearPerTravel, kNearPerTurn);
    const double draw = std::min(kLargestDraw_rad, travel.times(kDraw_rad, kDrawPerTravel, kDrawPerTurn));
    const int branch = nearestBranch(seed_wrist_.arm_angle);
    return at(comfortableArmAngle(postures_, ranges_, branch, seed_wrist_.arm_angle, draw), branch);
  }

  /// Within the ranges, nearest to the seed.
  [[nodiscard]] std::optional<Joints> withinRanges() const {
    std::optional<Joints> best;
    double best_turn = std::numeric_limits<double>::infinity();
    const ArmAngleRanges arm_angles(arm_, postures_, ranges_);  // what usable() shows lies inside
    for (const ArmAngleRange& range : arm_angles.usable()) {
      const double arm_angle = nearestIn(range);
      for (int branch = 0; branch < kSrsBranches; ++branch) {
        if ((range.branches >> branch & 1U) == 0) continue;
        const Joints exact = at(arm_angle, branch);
        const Joints q = exact.cwiseMax(ranges_.lower).cwiseMin(ranges_.upper);
        if (const double turn = farthest(q, seed_); turn < best_turn && farthest(q, exact) <= kRoundOff) {
          best = q;
          best_turn = turn;
        }
      }
    }
    return best;
  }

  [[nodiscard]] bool isNear(const Joints& q) const { return farthest(q, seed_) <= near_rad_; }

 private:
  [[nodiscard]] Joints at(double arm_angle, int branch) const {
    Joints q = postures_.posture(arm_angle, branch);
    keepTurns(q, seed_, arm_);
    return q;
  }

  [[nodiscard]] int nearestBranch(double arm_angle) const {
    auto all = postures_.branches(arm_angle);
    for (Joints& q : all) keepTurns(q, seed_, arm_);
    const auto nearer = [&](const Joints& one, const Joints& other) {
      return farthest(one, seed_) < farthest(other, seed_);
    };
    return static_cast<int>(std::min_element(all.begin(), all.end(), nearer) - all.begin());
  }

  [[nodiscard]] double nearestIn(const ArmAngleRange& range) const {
    const double inside = std::min(kInside_rad, 0.5 * (range.to - range.from));
    const double middle = 0.5 * (range.from + range.to);
    const double unrolled = middle + std::remainder(seed_wrist_.arm_angle - middle, 2.0 * kPi);
    return std::clamp(unrolled, range.from + inside, range.to - inside);
  }

  const SrsArm& arm_;
  const JointRanges& ranges_;
  const SrsPostures& postures_;
  const Joints& seed_;
  SrsWrist seed_wrist_;
  double near_rad_ = 0.0;
};

bool isAnswerable(const RigidTransform& X_BF, const Joints& seed) {
  return isRigid(X_BF) && seed.size() == kSrsJoints && seed.allFinite();
}

}  // namespace

Expected<Joints, NoPosture> PostureChoice::nearest(const RigidTransform& X_BF, const Joints& seed) const {
  if (!isAnswerable(X_BF, seed)) return unexpected(NoPosture::kOutOfReach);
  const auto postures = SrsPostures::at(arm_, X_BF);
  if (!postures) return unexpected(NoPosture::kOutOfReach);
  Question question(arm_, ranges_, *postures, seed);
  const Joints continued = question.continued(arm_.X_UB * X_BF * arm_.X_FW);
  if (ranges_.have(continued) && question.isNear(continued)) return continued;
  const auto other = question.withinRanges();
  if (!other) return unexpected(NoPosture::kOutsideLimits);
  if (!question.isNear(*other)) return unexpected(NoPosture::kOnlyWithJump);
  return *other;
}

Expected<Joints, NoPosture> PostureChoice::any(const RigidTransform& X_BF, const Joints& seed) const {
  if (!isAnswerable(X_BF, seed)) return unexpected(NoPosture::kOutOfReach);
  const auto postures = SrsPostures::at(arm_, X_BF);
  if (!postures) return unexpected(NoPosture::kOutOfReach);
  const auto found = Question(arm_, ranges_, *postures, seed).withinRanges();
  if (!found) return unexpected(NoPosture::kOutsideLimits);
  return *found;
}

std::string_view id(NoPosture reason) {
  switch (reason) {
    case NoPosture::kOutOfReach:
      return "out_of_reach";
    case NoPosture::kOutsideLimits:
      return "outside_limits";
    case NoPosture::kOnlyWithJump:
      return "only_with_jump";
  }
  return "unknown";
}

}  // namespace mirrorarm::robot
