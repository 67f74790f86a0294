#include "core/simulation/exercise_motion.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "core/simulation/smooth_ramp.h"

namespace mirrorarm::simulation {
namespace {

constexpr double kSleeveRadius_m = 0.045;

/// Along the forearm [mm] and around it [deg].
constexpr double kSleeve[][2] = {{-108, 12}, {-83, -41}, {-66, 38}, {-31, -9}, {-12, 47},
                                 {9, -34},   {38, 15},   {61, -48}, {79, 29},  {107, -17}};

Disc sleeveDisc(double along_m, double around_rad) {
  const Eigen::Vector3d outwards(0.0, std::sin(around_rad), std::cos(around_rad));
  return {along_m * Eigen::Vector3d::UnitX() + kSleeveRadius_m * outwards, outwards, 0.007};
}

std::vector<Disc> makeSleeve() {
  std::vector<Disc> discs;
  for (const auto& [along_mm, around_deg] : kSleeve)
    discs.push_back(sleeveDisc(1e-3 * along_mm, around_deg * std::numbers::pi / 180.0));
  return discs;
}

}  // namespace

const std::vector<Disc>& sleeveDiscs() {
  static const std::vector<Disc> discs = makeSleeve();
  return discs;
}

ExerciseMotion::ExerciseMotion(const RigidTransform& X_BA, std::vector<MinimumJerkLeg> legs)
    : X_BA_(X_BA), legs_(std::move(legs)) {
  for (const auto& leg : legs_) {
    assert(leg.duration_s > 0.0 && leg.rest_s >= 0.0);
    period_s_ += leg.duration_s + leg.rest_s;
  }
}

RigidTransform ExerciseMotion::poseAt(double phase_s) const {
  if (legs_.empty()) return X_BA_;
  double elapsed_s = std::fmod(std::max(phase_s, 0.0), period_s_);
  std::size_t i = 0;
  for (; i + 1 < legs_.size() && elapsed_s >= legs_[i].duration_s + legs_[i].rest_s; ++i)
    elapsed_s -= legs_[i].duration_s + legs_[i].rest_s;
  // The first round starts at rest, every further one where the last leg ended.
  const MinimumJerkLeg start = phase_s < period_s_ ? MinimumJerkLeg{} : legs_.back();
  const MinimumJerkLeg& from = i > 0 ? legs_[i - 1] : start;
  const double share = minimumJerk(elapsed_s / legs_[i].duration_s);
  const Eigen::Vector3d moved_B =
      from.displacement_m + share * (legs_[i].displacement_m - from.displacement_m);
  const double turn = from.forearm_turn_rad + share * (legs_[i].forearm_turn_rad - from.forearm_turn_rad);
  return Eigen::Translation3d(moved_B) * X_BA_ * Eigen::AngleAxisd(-turn, Eigen::Vector3d::UnitX());
}

int ExerciseMotion::discCount() const { return static_cast<int>(sleeveDiscs().size()); }

void ExerciseMotion::discsAt(double phase_s, std::span<Disc> discs) const {
  const RigidTransform X_BA = poseAt(phase_s);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Disc& disc_A = sleeveDiscs()[i];
    discs[i] = {X_BA * disc_A.p_B, X_BA.linear() * disc_A.normal_B, disc_A.diameter_m};
  }
}

ArmMotion::Forearm ExerciseMotion::forearmAt(double phase_s) const {
  const RigidTransform X_BA = poseAt(phase_s);
  const Eigen::Vector3d half(0.5 * kForearmLength_m, 0.0, 0.0);
  return {X_BA * Eigen::Vector3d(-half), X_BA * half};
}

}  // namespace mirrorarm::simulation
