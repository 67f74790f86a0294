#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/deviation_modes.h"

namespace mirrorarm::tracking {

/// One marker that was seen, as the fit of a frame takes it.
struct SeenMarker {
  std::size_t marker = 0;
  Eigen::Vector3d place_T = Eigen::Vector3d::Zero();        ///< where it was expected [m]
  Eigen::Vector3d innovation = Eigen::Vector3d::Zero();     ///< how far from there it was seen [m]
  Eigen::Matrix3d sensor_m2 = Eigen::Matrix3d::Zero();      ///< of the measurement and the teaching, in T
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();  ///< that and what it moves by itself
  bool counts = true;
  // What the fit says:
  double weight = 0.0;                                  ///< 0..1; 0 for an outlier
  Eigen::Vector3d left_over = Eigen::Vector3d::Zero();  ///< of the innovation [m]
  Eigen::Matrix3d fitted_m2 = Eigen::Matrix3d::Zero();  ///< of covariance_m2, the part the fit has taken
};

/// A motion of the whole body and steps of its modes' amplitudes that explain together how far the markers
/// were seen from where they were expected: generalised least squares with robust weights, the modes' steps
/// with a prior. With half of the markers hidden this tells a turn of the arm from a twist of its skin.
class DeviationFit {
 public:
  /// What is known before: the motion is zero with this information, an amplitude's step is zero with this
  /// variance [m^2]; a variance of zero keeps a mode still.
  struct Prior {
    Matrix6 motion_information = Matrix6::Zero();
    ModeVector mode_steps_m2 = ModeVector::Zero();
  };
  /// At least 3 markers that count, not on a line. Fills what the fit says into `seen`.
  void run(std::span<SeenMarker> seen, const DeviationModes& modes, const Prior& prior);

  /// Motion of the body, turn [rad] then shift [m], X_CT * exp(d).
  [[nodiscard]] Vector6 motion() const { return unknowns_.head<6>(); }
  [[nodiscard]] ModeVector amplitudeSteps() const { return unknowns_.tail<kModes>(); }

 private:
  static constexpr int kUnknowns = 6 + kModes;
  using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
  using Rows = Eigen::Matrix<double, 3, kUnknowns>;
  using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  template <int Size>
  void solve(std::span<const SeenMarker> seen, const Prior& prior);
  bool reweight(std::span<SeenMarker> seen);

  std::vector<Rows> rows_;
  std::vector<Eigen::Matrix3d> information_;
  std::vector<double> squares_;
  Unknowns unknowns_ = Unknowns::Zero();
  Normal covariance_ = Normal::Zero();
};

}  // namespace mirrorarm::tracking
