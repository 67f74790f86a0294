#include "core/calibration/bundle_equations.h"

#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "core/calibration/lens_numbers.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

constexpr Eigen::Index kPoseTerms = 6;
constexpr double kLeastCondition = 1e-13;  ///< of a matrix scaled to a unit diagonal

/// Where each kind of number begins.
class Layout {
 public:
  Layout(const Bundle& bundle, std::size_t board_points)
      : shared_(board_points > 0 ? static_cast<Eigen::Index>(board_points) + 1 : 0),
        second_lens_(shared_ + lensTerms(bundle.cameras[0].model)),
        poses_(shared_ + sharedTerms(bundle)),
        terms_(poses_ + kPoseTerms * static_cast<Eigen::Index>(bundle.X_CM.size())) {}
  [[nodiscard]] bool hasBoard() const { return shared_ > 0; }
  [[nodiscard]] Eigen::Index stretch() const { return shared_ - 1; }
  [[nodiscard]] Eigen::Index lens(std::size_t k) const { return k == 0 ? shared_ : second_lens_; }
  [[nodiscard]] Eigen::Index bar() const { return poses_ - kPoseTerms; }
  [[nodiscard]] Eigen::Index pose(std::size_t v) const {
    return poses_ + kPoseTerms * static_cast<Eigen::Index>(v);
  }
  [[nodiscard]] Eigen::Index terms() const { return terms_; }

 private:
  Eigen::Index shared_, second_lens_, poses_, terms_;
};

/// The few numbers that one point depends on: their derivatives side by side and where each stands.
class PointRow {
 public:
  template <class Block>
  void add(Eigen::Index first, const Block& by_numbers) {
    for (Eigen::Index i = 0; i < by_numbers.cols(); ++i) {
      J_.col(terms_) = by_numbers.col(i);
      at_[static_cast<std::size_t>(terms_++)] = first + i;
    }
  }
  void addTo(NormalEquations& sums, const Eigen::Vector2d& residual) const {
    const auto J = J_.leftCols(terms_);
    const Eigen::MatrixXd square = J.transpose() * J;
    const Eigen::VectorXd slope = J.transpose() * residual;
    for (Eigen::Index j = 0; j < terms_; ++j) {
      const auto column = at_[static_cast<std::size_t>(j)];
      sums.gradient[column] += slope[j];
      for (Eigen::Index i = 0; i < terms_; ++i)
        sums.matrix(at_[static_cast<std::size_t>(i)], column) += square(i, j);
    }
  }

 private:
  static constexpr int kMost = kMostLensTerms + 2 * static_cast<int>(kPoseTerms) + 2;
  Eigen::Matrix<double, 2, kMost> J_;
  std::array<Eigen::Index, kMost> at_{};
  Eigen::Index terms_ = 0;
};

struct Image {
  const SolvedLens& lens;
  std::size_t k, v;
};

[[nodiscard]] bool addPoint(const Bundle& bundle, const Layout& layout, const Image& image,
                            const Eigen::Vector3d& p_M, const SeenPoint& seen, NormalEquations& sums) {
  const RigidTransform& X_CM = bundle.X_CM[image.v];
  const RigidTransform X_KC = image.k == 0 ? RigidTransform::Identity() : bundle.X_RC;
  const Eigen::Vector3d p_C = X_CM * p_M;
  camera::CameraModel::ProjectJacobian by_K;
  LensJacobian by_lens;
  const auto pixel = image.lens.project(X_KC * p_C, by_K, by_lens);
  if (!pixel) return false;
  const double weight = seen.sigma_px > 0.0 ? 1.0 / seen.sigma_px : 1.0;
  const camera::CameraModel::ProjectJacobian by_C = weight * by_K * X_KC.linear();
  const camera::CameraModel::ProjectJacobian by_M = by_C * X_CM.linear();
  PointRow row;
  row.add(layout.lens(image.k), (weight * by_lens).eval());
  row.add(layout.pose(image.v), (by_M * motionAt(p_M)).eval());
  if (image.k > 0) row.add(layout.bar(), (by_C * motionAt(p_C)).eval());
  if (layout.hasBoard()) {
    row.add(seen.point, by_M.col(2));
    row.add(layout.stretch(), (0.5 * (by_M.col(0) * p_M.x() - by_M.col(1) * p_M.y())).eval());
  }
  const Eigen::Vector2d residual = weight * (*pixel - seen.pixel);
  row.addTo(sums, residual);
  sums.squares += residual.squaredNorm();
  ++sums.points;
  return true;
}

/// Factors that bring the diagonal to 1; numbers that nothing depends on stay as they are.
Eigen::VectorXd unitScale(const Eigen::MatrixXd& normal) {
  return normal.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 1.0; });
}

}  // namespace

Eigen::Index sharedTerms(const Bundle& bundle) {
  Eigen::Index terms = bundle.cameras.size() > 1 ? kPoseTerms : 0;
  for (const auto& camera : bundle.cameras) terms += lensTerms(camera.model);
  return terms;
}

std::optional<NormalEquations> normalEquations(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                                               std::span<const BoardView> views, bool with_board) {
  const Layout layout(bundle, with_board ? board.size() : 0);
  NormalEquations sums;
  sums.matrix.setZero(layout.terms(), layout.terms());
  sums.gradient.setZero(layout.terms());
  for (std::size_t k = 0; k < bundle.cameras.size(); ++k) {
    const SolvedLens lens(bundle.cameras[k]);
    for (std::size_t v = 0; v < views.size(); ++v)
      for (const auto& seen : views[v].seen[k])
        if (!addPoint(bundle, layout, {lens, k, v}, board[static_cast<std::size_t>(seen.point)], seen, sums))
          return std::nullopt;
  }
  return sums;
}

std::optional<NormalEquations> reduced(const NormalEquations& equations, Eigen::Index keep) {
  const Eigen::Index rest = equations.gradient.size() - keep;
  const Eigen::VectorXd scale = unitScale(equations.matrix).tail(rest);
  const Eigen::MatrixXd own =
      scale.asDiagonal() * equations.matrix.bottomRightCorner(rest, rest) * scale.asDiagonal();
  const Eigen::MatrixXd mixed = equations.matrix.topRightCorner(keep, rest) * scale.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(own);
  if (ldlt.info() != Eigen::Success || !(ldlt.vectorD().minCoeff() > kLeastCondition)) return std::nullopt;
  NormalEquations result = equations;
  result.matrix = equations.matrix.topLeftCorner(keep, keep) - mixed * ldlt.solve(mixed.transpose());
  const Eigen::VectorXd own_gradient = scale.asDiagonal() * equations.gradient.tail(rest);
  result.gradient = equations.gradient.head(keep) - mixed * ldlt.solve(own_gradient);
  return result;
}

std::optional<Eigen::MatrixXd> inverseOf(const Eigen::MatrixXd& normal) {
  const Eigen::VectorXd scale = unitScale(normal);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const auto& values = eigen.eigenvalues();
  if (!(values[0] > kLeastCondition * values[values.size() - 1])) return std::nullopt;
  const Eigen::MatrixXd half = scale.asDiagonal() * eigen.eigenvectors();
  return half * values.cwiseInverse().asDiagonal() * half.transpose();
}

}  // namespace mirrorarm::calibration
