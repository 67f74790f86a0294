#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/calibration/hand_eye_refusal.h"
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

/// Which solver gives the answer.
enum class HandEyeMethod {
  kTsaiLenzVisp,      ///< ViSP's, the paper's
  kTsaiLenzAllPairs,  ///< by least squares over all pairs of stations
  kParkMartin,
  kRefined,  ///< of greatest likelihood, from the all pairs' answer; the best, and with a covariance
};
/// "tsai-lenz (visp)", "tsai-lenz over all pairs", "park-martin", "refined".
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
  /// Standard deviation of X_PC's position along its worst axis [m], from the covariance where there is one,
  /// else by leaving out one station at a time. Nothing where the stations are too few to leave one out.
  std::optional<double> sigma_m;
  std::vector<std::size_t> outliers;  ///< stations left out, counted from 0
  std::vector<std::size_t> turned;    ///< stations that showed the board half a turn round; undone
  HandEyeMethod method = HandEyeMethod::kRefined;
  std::vector<StationResidual> stations;  ///< of all stations given, in their order
  /// Of a small motion of C (turn [rad], then shift [m]); absent where nothing was refined.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance;
};

/// Where the camera sits on the flange, or in the base, from at least 3 stations turned about two axes.
///
/// Stations that contradict the others (see contradictingStations) are left out and named; boards seen half a
/// turn round are turned back. Poses read in a wrong way (inverted, camera elsewhere, another order of the
/// quaternion, millimetres) are refused with the right one. kTsaiLenzVisp not for two threads at once: see
/// tsaiLenzByVisp. Source: paper section 2.1; Tsai, Lenz, IEEE Trans. Robotics and Automation 5(3), 1989.
[[nodiscard]] Expected<HandEyeSolution, HandEyeRefusal> solveHandEye(
    std::span<const PosePair> pairs, CameraMount mount, HandEyeMethod method = HandEyeMethod::kRefined);

}  // namespace mirrorarm::calibration
