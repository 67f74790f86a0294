#pragma once

#include <cmath>

#include <Eigen/Core>

namespace mirrorarm::vision {

/// Cholesky's factorisation of a symmetric positive definite matrix of a few rows, its diagonal scaled to one
/// first, for parameters that differ by magnitudes. At this size several times faster than general code, and
/// solved several times for each disc of each frame.
template <int N>
class SmallCholesky {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  /// Of `matrix` with `damping` times its diagonal added. False when it is not positive definite.
  bool factorise(const Matrix& matrix, double damping = 0.0) {
    for (int i = 0; i < N; ++i) {
      if (!(matrix(i, i) > 0.0)) return false;
      scale_(i) = 1.0 / std::sqrt(matrix(i, i));
    }
    for (int j = 0; j < N; ++j) {
      double pivot = 1.0 + damping;
      for (int k = 0; k < j; ++k) pivot -= L_[j][k] * L_[j][k];
      if (!(pivot > 1e-14)) return false;
      inverse_pivot_[j] = 1.0 / std::sqrt(pivot);
      for (int i = j + 1; i < N; ++i) {
        double value = matrix(i, j) * scale_(i) * scale_(j);
        for (int k = 0; k < j; ++k) value -= L_[i][k] * L_[j][k];
        L_[i][j] = value * inverse_pivot_[j];
      }
    }
    return true;
  }

  [[nodiscard]] Vector solve(const Vector& right) const {
    Vector x = right.cwiseProduct(scale_);
    for (int i = 0; i < N; ++i) {
      for (int k = 0; k < i; ++k) x(i) -= L_[i][k] * x(k);
      x(i) *= inverse_pivot_[i];
    }
    for (int i = N - 1; i >= 0; --i) {
      for (int k = i + 1; k < N; ++k) x(i) -= L_[k][i] * x(k);
      x(i) *= inverse_pivot_[i];
    }
    return x.cwiseProduct(scale_);
  }

  /// Inverse of the matrix.
  [[nodiscard]] Matrix inverse() const {
    double lower[N][N] = {};  // inverse of the factor
    for (int j = 0; j < N; ++j) {
      lower[j][j] = inverse_pivot_[j];
      for (int i = j + 1; i < N; ++i) {
        double value = 0.0;
        for (int k = j; k < i; ++k) value -= L_[i][k] * lower[k][j];
        lower[i][j] = value * inverse_pivot_[i];
      }
    }
    Matrix result;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= i; ++j) {
        double value = 0.0;
        for (int k = i; k < N; ++k) value += lower[k][i] * lower[k][j];
        result(i, j) = result(j, i) = value * scale_(i) * scale_(j);
      }
    return result;
  }

 private:
  double L_[N][N] = {};  ///< below the diagonal
  double inverse_pivot_[N] = {};
  Vector scale_;
};

}  // namespace mirrorarm::vision
