#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/calibration/pose_pairs.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

/// What carries the camera.
enum class CameraMount {
  kInHand,  ///< the flange: P below is F, and the calibration object stands still
  kToHand,  ///< the ground: P below is B, and the calibration object is fixed to the flange
};

/// "in-hand" or "to-hand", as the command line writes it.
[[nodiscard]] std::string_view name(CameraMount mount);
/// The mount of that name, or nothing.
[[nodiscard]] std::optional<CameraMount> cameraMountOf(std::string_view name);

/// Which solver's answer was taken.
enum class HandEyeMethod {
  kTsaiLenzVisp,      ///< ViSP's, the paper's; the first choice
  kTsaiLenzAllPairs,  ///< ours, where ViSP gave up or fits clearly worse
};
[[nodiscard]] std::string_view name(HandEyeMethod method);

/// How one station agrees with the solution.
struct StationResidual {
  double position_m = 0.0;  ///< of the object from X_QM
  double rotation_rad = 0.0;
  bool is_outlier = false;  ///< left out of the solution
};

struct HandEyeSolution {
  RigidTransform X_PC = RigidTransform::Identity();  ///< camera on what carries it
  RigidTransform X_QM = RigidTransform::Identity();  ///< object on what carries it: Q is the other of B and F
  double rms_m = 0.0;    ///< how far the object strays from X_QM over the stations used
  double rms_rad = 0.0;  ///< the same as an angle
  /// Standard deviation of X_PC's position along its worst axis, by leaving out one station at a time [m].
  /// Nothing where the stations are too few to leave one out.
  std::optional<double> sigma_m;
  std::vector<std::size_t> outliers;  ///< stations left out, counted from 0
  HandEyeMethod method = HandEyeMethod::kTsaiLenzVisp;
  std::vector<StationResidual> stations;  ///< of all stations given, in their order
  /// Of a small motion of C (turn [rad], then shift [m]); absent where nothing was refined.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance;
};

/// What the operator can mend.
enum class HandEyeError {
  kTooFewPairs,
  kNotRigid,
  kTurnsTooSmall,
  kOneAxis,
  kNotSolved,
  kInconsistent,
};
/// One line for an engineer: what is wrong and the remedy.
[[nodiscard]] std::string_view reason(HandEyeError error);

/// Where the camera sits on the flange, or in the base, from at least 3 stations turned about two axes.
///
/// A robust fit first finds stations that contradict the others (more than 4 times the median misfit); the
/// answer is then solved without them, by ViSP's Tsai-Lenz or, where that fits clearly worse, by Tsai-Lenz
/// over all pairs. Not for two threads at once: see tsaiLenzByVisp. Source: paper section 2.1; Tsai, Lenz,
/// IEEE Trans. Robotics and Automation 5(3), 1989.
[[nodiscard]] Expected<HandEyeSolution, HandEyeError> solveHandEye(std::span<const PosePair> pairs,
                                                                   CameraMount mount);

}  // namespace mirrorarm::calibration
