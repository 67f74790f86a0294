#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::experiments {

/// How a robot that holds the target moves from rest to rest.
enum class MoveProfile {
  kMinimumJerk,  ///< as an arm does
  kTrapezoid,    ///< as an industrial robot does: even acceleration, even speed, even braking
};
/// "minimum_jerk", "trapezoid".
[[nodiscard]] std::string_view id(MoveProfile profile);

/// One shift of the target.
struct HeldMove {
  double start_s = 0.0;
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  MoveProfile profile = MoveProfile::kMinimumJerk;

  /// Way along the shift [m].
  [[nodiscard]] double wayAt(double time_s) const;
  [[nodiscard]] double duration_s() const;
  [[nodiscard]] double end_s() const { return start_s + duration_s(); }
};

/// Out and back to either side along y and z of B, again and again, with rests of different length in
/// between, so that the cameras' beat meets each start at another time. Repeatable for a seed. Not along x:
/// at the bench's place the paper's 0.24 rad/s of the elbow let the hand go no faster than 0.068 m/s there.
[[nodiscard]] std::vector<HeldMove> movesToAndFro(MoveProfile profile, int count, double first_start_s,
                                                  unsigned seed);

/// Where the target is after all of them.
[[nodiscard]] Eigen::Vector3d shiftAt(const std::vector<HeldMove>& moves, double time_s);

}  // namespace mirrorarm::experiments
