#include "core/calibration/view_information.h"

#include "core/calibration/bundle_equations.h"
#include "core/calibration/lens_numbers.h"
#include "core/camera/stereo_view.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kNoise_px = 0.05;
// A data sheet's word on a lens and a bar.
constexpr double kFocalSigmaShare = 0.05;
constexpr double kCentreSigma_px = 20.0;
constexpr double kDistortionSigma = 0.1;
constexpr double kBarTurnSigma_rad = 0.02;
constexpr double kBarShiftSigma_m = 0.005;
// Of a board's pose against a robot's: the sizes matter only against each other.
constexpr double kTurnNoise_rad = 5e-4;
constexpr double kShiftNoise_m = 3e-4;
constexpr double kHandTurnSigma_rad = 0.1;
constexpr double kHandShiftSigma_m = 0.05;

/// Information of a number known to `sigma`.
double known(double sigma) { return 1.0 / (sigma * sigma); }

SeenPoint pointAt(std::size_t point, const Eigen::Vector2d& pixel) {
  SeenPoint seen;
  seen.point = static_cast<int>(point);
  seen.pixel = pixel;
  seen.sigma_px = kNoise_px;
  return seen;
}

}  // namespace

RigInformation::RigInformation(const camera::StereoRig& rig, std::span<const Eigen::Vector3d> board)
    : rig_(rig), board_(board.begin(), board.end()) {}

Eigen::MatrixXd RigInformation::prior() const {
  std::vector<double> diagonal;
  for (const auto& camera : {rig_.left, rig_.right}) {
    const auto& lens = camera.intrinsics();
    diagonal.insert(diagonal.end(),
                    {known(kFocalSigmaShare * lens.fx_px), known(kFocalSigmaShare * lens.fy_px),
                     known(kCentreSigma_px), known(kCentreSigma_px)});
    diagonal.insert(diagonal.end(), static_cast<std::size_t>(lensTerms(lens.model) - kPinholeTerms),
                    known(kDistortionSigma));
  }
  diagonal.insert(diagonal.end(), 3, known(kBarTurnSigma_rad));
  diagonal.insert(diagonal.end(), 3, known(kBarShiftSigma_m));
  return Eigen::Map<const Eigen::VectorXd>(diagonal.data(), static_cast<Eigen::Index>(diagonal.size()))
      .asDiagonal();
}

Eigen::MatrixXd RigInformation::of(const RigidTransform& X_CM) const {
  const Bundle bundle{{rig_.left.intrinsics(), rig_.right.intrinsics()}, rig_.X_RC, {X_CM}};
  BoardView view;
  for (std::size_t i = 0; i < board_.size(); ++i) {
    const Eigen::Vector3d p_C = X_CM * board_[i];
    if (!camera::bothCamerasSee(rig_, p_C)) continue;
    view.seen[0].push_back(pointAt(i, *rig_.left.project(p_C)));
    view.seen[1].push_back(pointAt(i, *rig_.right.project(rig_.X_RC * p_C)));
  }
  const auto terms = sharedTerms(bundle);
  const auto equations = normalEquations(bundle, board_, {&view, 1});
  const auto shared = equations ? reduced(*equations, terms) : std::nullopt;
  return shared ? shared->matrix : Eigen::MatrixXd::Zero(terms, terms);
}

HandEyeInformation::Matrix12 HandEyeInformation::prior() {
  Eigen::Matrix<double, 12, 1> diagonal;
  for (const int at : {0, 6}) {
    diagonal.segment<3>(at).setConstant(known(kHandTurnSigma_rad));
    diagonal.segment<3>(at + 3).setConstant(known(kHandShiftSigma_m));
  }
  return diagonal.asDiagonal();
}

// A station compares X_BM with X_BF X_FC X_CM: a small motion d of C moves the board by the adjoint of X_MC.
HandEyeInformation::Matrix12 HandEyeInformation::of(const RigidTransform& X_CM) {
  const RigidTransform X_MC = X_CM.inverse();
  Eigen::Matrix<double, 6, 12> J = Eigen::Matrix<double, 6, 12>::Zero();
  J.block<3, 3>(0, 0) = J.block<3, 3>(3, 3) = X_MC.linear();
  J.block<3, 3>(3, 0) = crossMatrix(X_MC.translation()) * X_MC.linear();
  J.rightCols<6>() = -Eigen::Matrix<double, 6, 6>::Identity();
  J.topRows<3>() /= kTurnNoise_rad;
  J.bottomRows<3>() /= kShiftNoise_m;
  return J.transpose() * J;
}

}  // namespace mirrorarm::calibration
