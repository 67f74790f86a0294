#include "core/robot/srs_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::robot {
namespace {

constexpr double kPi = std::numbers::pi;

/// Arm angles at which some joint reaches an end of its range, or is half a turn from it.
class Cuts {
 public:
  /// Where direction (x, y), of which the arm angle turns both, points along `angle` or against it.
  void addTurn(const SrsPostures::Turning& R, std::array<int, 2> x, std::array<int, 2> y, double sign_x,
               double angle) {
    const double c = std::cos(angle), s = sign_x * std::sin(angle);
    const auto off = [&](const Eigen::Matrix3d& M) { return c * M(y[0], y[1]) - s * M(x[0], x[1]); };
    addRoots(off(R.sine), off(R.cosine), off(R.constant));
  }

  /// Where the middle angle of the joint is `angle` or its opposite.
  void addBend(const SrsPostures::Turning& R, double angle) {
    addRoots(R.sine(2, 2), R.cosine(2, 2), R.constant(2, 2) - std::cos(angle));
  }

  std::span<const double> sorted() {
    std::sort(cuts_.begin(), cuts_.begin() + count_);
    return {cuts_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  /// a sin(psi) + b cos(psi) + c = 0.
  void addRoots(double a, double b, double c) {
    const double size = std::hypot(a, b);
    if (size <= std::abs(c)) return;
    const double middle = std::atan2(a, b), half = std::acos(-c / size);
    for (const double psi : {middle - half, middle + half})
      cuts_[static_cast<std::size_t>(count_++)] = std::remainder(psi, 2.0 * kPi);
  }

  std::array<double, 24> cuts_{};
  int count_ = 0;
};

unsigned branchesWithin(const SrsPostures& postures, const JointRanges& ranges, double arm_angle) {
  const auto all = postures.branches(arm_angle);
  unsigned within = 0;
  for (std::size_t b = 0; b < all.size(); ++b)
    if (ranges.have(all[b])) within |= 1U << b;
  return within;
}

}  // namespace

ArmAngleRanges::ArmAngleRanges(const SrsArm& arm, const SrsPostures& postures, const JointRanges& ranges) {
  Cuts cuts;
  for (const auto* ends : {&ranges.lower, &ranges.upper}) {
    const auto end = [&](int joint) { return arm.sign[static_cast<std::size_t>(joint)] * (*ends)[joint]; };
    for (const int first : {0, 4}) {
      const auto& R = first == 0 ? postures.shoulder() : postures.wrist();
      cuts.addTurn(R, {0, 2}, {1, 2}, 1.0, end(first));
      cuts.addBend(R, end(first + 1));
      cuts.addTurn(R, {2, 0}, {2, 1}, -1.0, end(first + 2));
    }
  }
  const auto sorted = cuts.sorted();
  if (sorted.empty()) {
    if (const unsigned all_round = branchesWithin(postures, ranges, 0.0); all_round != 0)
      usable_[count_++] = {-kPi, kPi, all_round};
    return;
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double from = sorted[i], to = i + 1 < sorted.size() ? sorted[i + 1] : sorted[0] + 2.0 * kPi;
    const unsigned branches = branchesWithin(postures, ranges, 0.5 * (from + to));
    if (branches != 0) usable_[count_++] = {from, to, branches};
  }
}

}  // namespace mirrorarm::robot
