#include "core/geometry/dual_quaternion.h"

#include <cassert>
#include <cmath>

namespace mirrorarm {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

// Equations 28 and 29; the scalar part stands last.
Matrix4d matrixP(const Vector4d& r) {
  Matrix4d P;
  P << r[3], -r[2], r[1], r[0],  //
      r[2], r[3], -r[0], r[1],   //
      -r[1], r[0], r[3], r[2],   //
      -r[0], -r[1], -r[2], r[3];
  return P;
}

Matrix4d matrixW(const Vector4d& r) {
  Matrix4d W;
  W << r[3], r[2], -r[1], r[0],  //
      -r[2], r[3], r[0], r[1],   //
      r[1], -r[0], r[3], r[2],   //
      -r[0], -r[1], -r[2], r[3];
  return W;
}

Vector4d pointQuaternion(const Vector3d& p) { return {p.x(), p.y(), p.z(), 0.0}; }

/// Sums of equation 31 over all coupled pairs.
struct Energy {
  Matrix4d C1 = Matrix4d::Zero();
  Matrix4d C3 = Matrix4d::Zero();
  double weight = 0.0;

  void add(const Vector3d& x, const Vector3d& y, double m) {
    const Matrix4d W = matrixW(pointQuaternion(x));
    const Matrix4d P = matrixP(pointQuaternion(y));
    C1 -= m * P.transpose() * W;
    C3 += m * (W - P);
    weight += m;
  }
};

/// Power iteration by repeated squaring: after k rounds the start has been multiplied 2^k times, so even
/// close eigenvalues part. The shift makes every eigenvalue positive, hence the largest also the dominant
/// one.
Vector4d dominantEigenvector(const Matrix4d& A) {
  Matrix4d power = A + A.norm() * Matrix4d::Identity();
  const double start = power.trace();
  if (!(start > 0.0)) return Vector4d::UnitW();
  power /= start;
  constexpr int max_rounds = 50;
  for (int round = 0; round < max_rounds; ++round) {
    const Matrix4d squared = power * power;
    const double trace = squared.trace();
    power = squared / trace;
    if (1.0 - trace < 1e-15) break;
  }
  Eigen::Index widest = 0;
  power.diagonal().maxCoeff(&widest);
  return power.col(widest).normalized();
}

RigidTransform minimum(const Energy& energy) {
  assert(energy.weight > 0.0);
  const double C2 = 0.5 * energy.weight;  // times the identity
  const Matrix4d A = 0.25 * energy.C3.transpose() * energy.C3 / C2 - energy.C1;
  const Vector4d r = dominantEigenvector(0.5 * (A + A.transpose()));
  const Vector4d s = -0.5 / C2 * energy.C3 * r;
  const Matrix4d Wt = matrixW(r).transpose();
  return makeTransform(Eigen::Matrix3d((Wt * matrixP(r)).topLeftCorner<3, 3>()),
                       Vector3d((Wt * s).head<3>()));
}

/// Both clouds are laid about their own middle first: far from it, C3 and C1 would nearly cancel in A.
struct Middles {
  Vector3d x;
  Vector3d y;

  Middles(std::span<const Vector3d> xs, std::span<const Vector3d> ys) : x(middle(xs)), y(middle(ys)) {}

  /// The pose of what was given, from that of what was laid about the middles.
  [[nodiscard]] RigidTransform restore(RigidTransform X) const {
    X.translation() += y - X.linear() * x;
    return X;
  }

 private:
  static Vector3d middle(std::span<const Vector3d> points) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& p : points) sum += p;
    return points.empty() ? sum : Vector3d(sum / static_cast<double>(points.size()));
  }
};

}  // namespace

RigidTransform fitByDualQuaternion(std::span<const Vector3d> x, std::span<const Vector3d> y,
                                   std::span<const double> weights) {
  assert(x.size() == y.size() && x.size() == weights.size());
  const Middles middles(x, y);
  Energy energy;
  for (std::size_t i = 0; i < x.size(); ++i) energy.add(x[i] - middles.x, y[i] - middles.y, weights[i]);
  return middles.restore(minimum(energy));
}

RigidTransform fitByDualQuaternion(std::span<const Vector3d> x, std::span<const Vector3d> y,
                                   const Eigen::Ref<const Eigen::MatrixXd>& weights) {
  assert(weights.rows() == static_cast<Eigen::Index>(x.size()));
  assert(weights.cols() == static_cast<Eigen::Index>(y.size()));
  const Middles middles(x, y);
  Energy energy;
  for (std::size_t j = 0; j < x.size(); ++j)
    for (std::size_t k = 0; k < y.size(); ++k)
      energy.add(x[j] - middles.x, y[k] - middles.y,
                 weights(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)));
  return middles.restore(minimum(energy));
}

}  // namespace mirrorarm
