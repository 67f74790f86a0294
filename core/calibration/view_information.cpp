#include "core/calibration/view_information.h"

#include <Eigen/Dense>

#include "core/camera/stereo_view.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

using camera::CameraModel;

constexpr int kPinhole = 4;
constexpr double kNoise_px = 0.05;
// A data sheet's word on a lens and a bar.
constexpr double kFocalSigmaShare = 0.05;
constexpr double kCentreSigma_px = 20.0;
constexpr double kDistortionSigma = 0.1;
constexpr double kBarTurnSigma_rad = 0.02;
constexpr double kBarShiftSigma_m = 0.005;
// Steps of the central differences.
constexpr double kPinholeStep_px = 0.1;
constexpr double kDistortionStep = 1e-5;
// Of a board's pose against a robot's: the sizes matter only against each other.
constexpr double kTurnNoise_rad = 5e-4;
constexpr double kShiftNoise_m = 3e-4;
constexpr double kHandTurnSigma_rad = 0.1;
constexpr double kHandShiftSigma_m = 0.05;

int distortionTerms(const camera::Intrinsics& lens) {
  return lens.model == camera::LensModel::kBrownConrady ? 2 : 4;
}

double& number(camera::Intrinsics& lens, int i) {
  double* const pinhole[] = {&lens.fx_px, &lens.fy_px, &lens.cx_px, &lens.cy_px};
  return i < kPinhole ? *pinhole[i] : lens.distortion[static_cast<std::size_t>(i - kPinhole)];
}

double square(double x) { return x * x; }

/// Information of a number known to `sigma`.
double known(double sigma) { return 1.0 / square(sigma); }

}  // namespace

RigInformation::Lens RigInformation::lensOf(const CameraModel& camera) {
  Lens lens{camera, {}, {}};
  for (int i = 0; i < kPinhole + distortionTerms(camera.intrinsics()); ++i) {
    lens.step.push_back(i < kPinhole ? kPinholeStep_px : kDistortionStep);
    auto below = camera.intrinsics(), above = below;
    number(below, i) -= lens.step.back();
    number(above, i) += lens.step.back();
    lens.beside.push_back({CameraModel(below), CameraModel(above)});
  }
  return lens;
}

RigInformation::RigInformation(const camera::StereoRig& rig, std::span<const Eigen::Vector3d> board)
    : rig_(rig), board_(board.begin(), board.end()), lenses_{lensOf(rig.left), lensOf(rig.right)} {}

Eigen::Index RigInformation::terms() const {
  return static_cast<Eigen::Index>(lenses_[0].step.size() + lenses_[1].step.size()) + 6;
}

Eigen::MatrixXd RigInformation::prior() const {
  Eigen::VectorXd diagonal(terms());
  Eigen::Index at = 0;
  for (const auto& lens : lenses_) {
    const auto& numbers = lens.camera.intrinsics();
    diagonal.segment<4>(at) << known(kFocalSigmaShare * numbers.fx_px),
        known(kFocalSigmaShare * numbers.fy_px), known(kCentreSigma_px), known(kCentreSigma_px);
    diagonal.segment(at + kPinhole, distortionTerms(numbers)).setConstant(known(kDistortionSigma));
    at += static_cast<Eigen::Index>(lens.step.size());
  }
  diagonal.segment<3>(at).setConstant(known(kBarTurnSigma_rad));
  diagonal.segment<3>(at + 3).setConstant(known(kBarShiftSigma_m));
  return diagonal.asDiagonal();
}

/// Adds a point's two images to the normal equations of the shared numbers and, behind them, the view's pose.
void RigInformation::addPoint(const Eigen::Vector3d& p_M, const RigidTransform& X_CM,
                              Eigen::MatrixXd& equations) const {
  const Eigen::Vector3d p_C = X_CM * p_M;
  Eigen::Matrix2Xd J(2, terms() + 6);
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < lenses_.size(); ++k) {
    const auto& lens = lenses_[k];
    const RigidTransform X_KC = k == 0 ? RigidTransform::Identity() : rig_.X_RC;
    const Eigen::Vector3d p_K = X_KC * p_C;
    J.setZero();
    for (std::size_t i = 0; i < lens.step.size(); ++i, ++at) {
      const auto below = lens.beside[i][0].project(p_K);
      const auto above = lens.beside[i][1].project(p_K);
      if (below && above) J.col(at) = (*above - *below) / (2.0 * lens.step[i]);
    }
    CameraModel::ProjectJacobian by_point;
    if (!lens.camera.project(p_K, by_point)) continue;
    if (k == 1) J.middleCols<6>(terms() - 6) = by_point * X_KC.linear() * motionAt(p_C);
    J.rightCols<6>() = by_point * X_KC.linear() * X_CM.linear() * motionAt(p_M);
    equations.noalias() += J.transpose() * J / square(kNoise_px);
  }
}

Eigen::MatrixXd RigInformation::of(const RigidTransform& X_CM) const {
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(terms() + 6, terms() + 6);
  for (const auto& p_M : board_)
    if (camera::bothCamerasSee(rig_, X_CM * p_M)) addPoint(p_M, X_CM, equations);
  const Eigen::MatrixXd mixed = equations.topRightCorner(terms(), 6);
  const Eigen::LDLT<Eigen::MatrixXd> own(equations.bottomRightCorner(6, 6));
  if (own.info() != Eigen::Success || !own.isPositive()) return Eigen::MatrixXd::Zero(terms(), terms());
  return equations.topLeftCorner(terms(), terms()) - mixed * own.solve(mixed.transpose());
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
