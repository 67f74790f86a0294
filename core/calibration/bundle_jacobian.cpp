#include "core/calibration/bundle_jacobian.h"

#include <cmath>

#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

using camera::CameraModel;
using camera::Intrinsics;
using Jacobian26 = Eigen::Matrix<double, 2, 6>;

constexpr Eigen::Index kPinhole = 4;  ///< fx fy cx cy
constexpr double kDistortionStep = 1e-6;

Eigen::Index distortionTerms(const Intrinsics& camera) {
  return camera.model == camera::LensModel::kBrownConrady ? 2 : 4;
}

Eigen::Index intrinsicTerms(const Intrinsics& camera) { return kPinhole + distortionTerms(camera); }

Eigen::Index sharedTerms(const Bundle& bundle) {
  return firstIntrinsic(bundle, bundle.cameras.size()) + (bundle.cameras.size() > 1 ? 6 : 0);
}

/// X with its rotation turned by the vector's first half and its origin moved by the second.
RigidTransform moved(const RigidTransform& X, const Vector6& step) {
  const Eigen::Vector3d turn = step.head<3>();
  const Eigen::AngleAxisd rotation(turn.norm(), turn.stableNormalized());
  return makeTransform(Eigen::Quaterniond(rotation * Eigen::Quaterniond(X.linear())),
                       X.translation() + step.tail<3>());
}

Intrinsics moved(Intrinsics camera, const Eigen::VectorXd& step) {
  camera.fx_px += step[0];
  camera.fy_px += step[1];
  camera.cx_px += step[2];
  camera.cy_px += step[3];
  for (Eigen::Index i = 0; i < distortionTerms(camera); ++i)
    camera.distortion[static_cast<std::size_t>(i)] += step[kPinhole + i];
  return camera;
}

/// A lens with its neighbours in each distortion term, for central differences: the model gives derivatives
/// by the point alone.
class Lens {
 public:
  explicit Lens(const Intrinsics& camera) : intrinsics_(camera), model_(camera) {
    for (Eigen::Index i = 0; i < distortionTerms(camera); ++i)
      for (const double step : {-kDistortionStep, kDistortionStep}) {
        Intrinsics beside = camera;
        beside.distortion[static_cast<std::size_t>(i)] += step;
        beside_.emplace_back(beside);
      }
  }

  /// Pixel of p_K with its derivatives by the point and by the intrinsics.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_K,
                                                       CameraModel::ProjectJacobian& by_point,
                                                       Eigen::Matrix2Xd& by_intrinsics) const {
    const auto pixel = model_.project(p_K, by_point);
    if (!pixel) return std::nullopt;
    by_intrinsics.setZero(2, intrinsicTerms(intrinsics_));
    by_intrinsics(0, 0) = (pixel->x() - intrinsics_.cx_px) / intrinsics_.fx_px;
    by_intrinsics(1, 1) = (pixel->y() - intrinsics_.cy_px) / intrinsics_.fy_px;
    by_intrinsics(0, 2) = by_intrinsics(1, 3) = 1.0;
    for (std::size_t i = 0; i < beside_.size(); i += 2) {
      const auto below = beside_[i].project(p_K);
      const auto above = beside_[i + 1].project(p_K);
      if (!below || !above) return std::nullopt;
      by_intrinsics.col(kPinhole + static_cast<Eigen::Index>(i / 2)) =
          (*above - *below) / (2.0 * kDistortionStep);
    }
    return pixel;
  }

 private:
  Intrinsics intrinsics_;
  CameraModel model_;
  std::vector<CameraModel> beside_;
};

/// Adds one image's points to the equations.
class Accumulator {
 public:
  Accumulator(const Bundle& bundle, std::size_t k, Linearised& problem)
      : lens_(bundle.cameras[k]),
        X_KC_(k == 0 ? RigidTransform::Identity() : bundle.X_RC),
        first_(firstIntrinsic(bundle, k)),
        bar_(k == 0 ? -1 : firstIntrinsic(bundle, bundle.cameras.size())),
        problem_(problem) {}

  [[nodiscard]] bool add(const RigidTransform& X_CM, const Eigen::Vector3d& p_M, const Eigen::Vector2d& seen,
                         ViewEquations& view) {
    const Eigen::Vector3d arm_C = X_CM.linear() * p_M;
    const Eigen::Vector3d p_C = arm_C + X_CM.translation();
    const Eigen::Vector3d arm_K = X_KC_.linear() * p_C;
    CameraModel::ProjectJacobian by_point;
    const auto pixel = lens_.project(arm_K + X_KC_.translation(), by_point, by_intrinsics_);
    if (!pixel) return false;
    by_shared_.setZero(2, problem_.shared.rows());
    by_shared_.middleCols(first_, by_intrinsics_.cols()) = by_intrinsics_;
    if (bar_ >= 0) by_shared_.middleCols<6>(bar_) = byPose(by_point, arm_K);
    const Jacobian26 by_view = byPose(by_point * X_KC_.linear(), arm_C);
    accumulate(*pixel - seen, by_view, view);
    return true;
  }

 private:
  static Jacobian26 byPose(const CameraModel::ProjectJacobian& by_point, const Eigen::Vector3d& arm) {
    Jacobian26 J;
    J << -by_point * crossMatrix(arm), by_point;
    return J;
  }

  void accumulate(const Eigen::Vector2d& residual, const Jacobian26& by_view, ViewEquations& view) {
    problem_.shared.noalias() += by_shared_.transpose() * by_shared_;
    problem_.shared_gradient.noalias() += by_shared_.transpose() * residual;
    view.mixed.noalias() += by_shared_.transpose() * by_view;
    view.own.noalias() += by_view.transpose() * by_view;
    view.own_gradient.noalias() += by_view.transpose() * residual;
  }

  Lens lens_;
  RigidTransform X_KC_;
  Eigen::Index first_;
  Eigen::Index bar_;
  Linearised& problem_;
  Eigen::Matrix2Xd by_intrinsics_;
  Eigen::Matrix2Xd by_shared_;
};

}  // namespace

Eigen::Index firstIntrinsic(const Bundle& bundle, std::size_t k) {
  Eigen::Index terms = 0;
  for (std::size_t i = 0; i < k; ++i) terms += intrinsicTerms(bundle.cameras[i]);
  return terms;
}

std::optional<Linearised> linearise(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                                    std::span<const BoardView> views) {
  const auto terms = sharedTerms(bundle);
  Linearised problem;
  problem.shared.setZero(terms, terms);
  problem.shared_gradient.setZero(terms);
  problem.views.resize(views.size());
  for (auto& view : problem.views) view.mixed.setZero(terms, 6);
  for (std::size_t k = 0; k < bundle.cameras.size(); ++k) {
    Accumulator equations(bundle, k, problem);
    for (std::size_t v = 0; v < views.size(); ++v)
      for (const auto& seen : views[v].seen[k])
        if (!equations.add(bundle.X_CM[v], board[static_cast<std::size_t>(seen.point)], seen.pixel,
                           problem.views[v]))
          return std::nullopt;
  }
  return problem;
}

std::optional<double> sumOfSquares(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                                   std::span<const BoardView> views) {
  double sum = 0.0;
  for (std::size_t k = 0; k < bundle.cameras.size(); ++k) {
    const CameraModel camera(bundle.cameras[k]);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const RigidTransform X_KM = k == 0 ? bundle.X_CM[v] : bundle.X_RC * bundle.X_CM[v];
      for (const auto& seen : views[v].seen[k]) {
        const auto pixel = camera.project(X_KM * board[static_cast<std::size_t>(seen.point)]);
        if (!pixel) return std::nullopt;
        sum += (*pixel - seen.pixel).squaredNorm();
      }
    }
  }
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

Bundle moved(const Bundle& bundle, const BundleStep& step) {
  Bundle next = bundle;
  for (std::size_t k = 0; k < next.cameras.size(); ++k)
    next.cameras[k] = moved(next.cameras[k],
                            step.shared.segment(firstIntrinsic(bundle, k), intrinsicTerms(next.cameras[k])));
  if (next.cameras.size() > 1) next.X_RC = moved(next.X_RC, Vector6(step.shared.tail<6>()));
  for (std::size_t v = 0; v < next.X_CM.size(); ++v) next.X_CM[v] = moved(next.X_CM[v], step.views[v]);
  return next;
}

}  // namespace mirrorarm::calibration
