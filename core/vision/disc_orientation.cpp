#include "core/vision/disc_orientation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace mirrorarm::vision {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kRounds = 5;
constexpr double kSettled = 1e-3;        // a step, in radii, after which the next one is lost in noise
constexpr double kFloor_px = 0.02;       // of a semi axis: what blur, pixels and perspective leave out
constexpr double kFloorOfAxis = 0.003;   // likewise, in parts of the longer one
constexpr double kCutFloorOfAxis = 0.1;  // a cut outline was helped out by the fit
constexpr double kAxisOfCentre = 1.5;    // variance of an axis against the centre's, where only that is known
constexpr double kWorthATry = 50.0;      // chi squared that a mirrored start may be worse
constexpr double kHopeless = 500.0;      // chi squared that no descent brings down far enough
constexpr double kPriorTilt_rad = 0.7;  // discs show their faces: keeps what two far views cannot tell finite

/// (xx, xy, yy) of a symmetric matrix.
Vector3d packed(const Matrix2d& m) { return {m(0, 0), m(0, 1), m(1, 1)}; }

/// One image of the disc: the outline's shape as measured and the affine map that it went through.
struct Outline {
  camera::CameraModel::ProjectJacobian by_point;
  Matrix2d gram;  ///< by_point * by_point^T
  Vector3d shape;
  Matrix3d weight;
};

double floorOf(const DetectedMarker& marker) {
  const double a = marker.ellipse.semi_major_px;
  double variance = kFloor_px * kFloor_px + std::pow((marker.cut ? kCutFloorOfAxis : kFloorOfAxis) * a, 2);
  if (!(marker.shape_covariance_px4.trace() > 0.0))
    variance += 0.5 * kAxisOfCentre * marker.covariance_px2.trace();
  return 4.0 * a * a * variance;
}

Outline outlineOf(const PointImage& image, const DetectedMarker& marker) {
  const double floor = floorOf(marker);
  const Matrix3d covariance =
      marker.shape_covariance_px4 + Vector3d(floor, 0.5 * floor, floor).asDiagonal().toDenseMatrix();
  return {image.by_point, image.by_point * image.by_point.transpose(), packed(shapeOf(marker.ellipse)),
          covariance.inverse()};
}

/// The unknown is m = r n: the outline's shape matrix is J (m^2 I - m m^T) J^T.
struct Residual {
  Vector3d value;
  Matrix3d by_m;
};

Residual residual(const Outline& outline, const Vector3d& m) {
  const Vector2d a = outline.by_point * m;
  const auto& J = outline.by_point;
  const Matrix2d shape = m.squaredNorm() * outline.gram - a * a.transpose();
  Residual result;
  result.value = packed(shape) - outline.shape;
  result.by_m.row(0) = 2.0 * (outline.gram(0, 0) * m.transpose() - a.x() * J.row(0));
  result.by_m.row(1) = 2.0 * outline.gram(0, 1) * m.transpose() - a.x() * J.row(1) - a.y() * J.row(0);
  result.by_m.row(2) = 2.0 * (outline.gram(1, 1) * m.transpose() - a.y() * J.row(1));
  return result;
}

double misfitOf(const Outline& outline, const Vector3d& m) {
  const Vector2d a = outline.by_point * m;
  const Vector3d off = packed(m.squaredNorm() * outline.gram - a * a.transpose()) - outline.shape;
  return off.dot(outline.weight * off);
}

using Outlines = std::array<Outline, 2>;

double misfitOf(const Outlines& outlines, const Vector3d& m) {
  return misfitOf(outlines[0], m) + misfitOf(outlines[1], m);
}

/// Both m that explain one outline wholly. The camera looks along the map's null space.
std::optional<std::array<Vector3d, 2>> explaining(const Outline& outline) {
  const Vector3d row_x = outline.by_point.row(0);
  const Vector3d row_y = outline.by_point.row(1);
  const Vector3d away = row_x.cross(row_y).normalized();
  const Vector3d e_x = row_x.normalized();
  const Vector3d e_y = away.cross(e_x);
  Matrix2d B;
  B << row_x.norm(), 0.0, row_y.dot(e_x), row_y.dot(e_y);
  const Matrix2d inverse = B.inverse();
  Matrix2d shape;
  shape << outline.shape(0), outline.shape(1), outline.shape(1), outline.shape(2);
  Eigen::SelfAdjointEigenSolver<Matrix2d> eigen;
  eigen.computeDirect(inverse * shape * inverse.transpose());
  const Vector2d squares = eigen.eigenvalues();
  if (!(squares(0) > 0.0) || !squares.allFinite()) return std::nullopt;
  const Vector2d minor = eigen.eigenvectors().col(0);
  const Vector3d aside = std::sqrt(squares(1) - squares(0)) * (minor.x() * e_x + minor.y() * e_y);
  const Vector3d towards = -std::sqrt(squares(0)) * away;
  return std::array<Vector3d, 2>{towards + aside, towards - aside};
}

struct Solution {
  Vector3d m = Vector3d::Zero();
  Matrix3d covariance = Matrix3d::Zero();
  double misfit = 0.0;
};

/// One step of Gauss and Newton with a weak pull towards a disc that faces the cameras.
Vector3d step(const Outlines& outlines, const Matrix3d& prior, Solution& solution) {
  Matrix3d matrix = prior;
  Vector3d vector = prior * solution.m;
  for (const auto& outline : outlines) {
    const Residual r = residual(outline, solution.m);
    const Matrix3d pull = r.by_m.transpose() * outline.weight;
    matrix += pull * r.by_m;
    vector += pull * r.value;
  }
  solution.covariance = matrix.inverse();
  return -(solution.covariance * vector);
}

Solution descend(const Outlines& outlines, const Solution& start, const Vector3d& facing) {
  const double r2 = start.m.squaredNorm();
  const Matrix3d across = Matrix3d::Identity() - facing * facing.transpose();
  const Matrix3d prior = across / (r2 * kPriorTilt_rad * kPriorTilt_rad);
  Solution solution = start;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d by = step(outlines, prior, solution);
    solution.m += by;
    if (by.squaredNorm() < kSettled * kSettled * r2) break;
  }
  solution.misfit = misfitOf(outlines, solution.m);
  if (solution.misfit <= start.misfit) return solution;
  return {start.m, solution.covariance, start.misfit};
}

/// The likelier of two, as uncertain as both together: where noise alone decides, the covariance says so.
Solution mixed(const Solution& one, const Solution& other) {
  const bool one_is_likelier = one.misfit <= other.misfit;
  Solution best = one_is_likelier ? one : other;
  const Solution& second = one_is_likelier ? other : one;
  const double odds = std::exp(-0.5 * (second.misfit - best.misfit));
  const double share = odds / (1.0 + odds);
  const Vector3d apart = second.m - best.m;
  best.covariance += share * (second.covariance - best.covariance + apart * apart.transpose());
  return best;
}

Solution solve(const Outlines& outlines, const std::array<Vector3d, 4>& candidates) {
  std::array<Solution, 4> starts;
  for (std::size_t i = 0; i < starts.size(); ++i)
    starts[i] = {candidates[i], Matrix3d::Zero(), misfitOf(outlines, candidates[i])};
  const auto least = std::min_element(
      starts.begin(), starts.end(), [](const Solution& a, const Solution& b) { return a.misfit < b.misfit; });
  if (least->misfit > kHopeless) return *least;
  const Vector3d facing = (candidates[0] + candidates[1] + candidates[2] + candidates[3]).normalized();
  const Solution solution = descend(outlines, *least, facing);
  const auto mirrored = static_cast<std::size_t>(least - starts.begin()) ^ 1U;
  if (!(starts[mirrored].misfit < least->misfit + kWorthATry)) return solution;
  return mixed(solution, descend(outlines, starts[mirrored], facing));
}

}  // namespace

std::optional<DiscOrientation> discOrientation(const ImagedPoint& images, const DetectedMarker& left,
                                               const DetectedMarker& right) {
  const Outlines outlines{outlineOf(images.left, left), outlineOf(images.right, right)};
  const auto a = explaining(outlines[0]);
  const auto b = explaining(outlines[1]);
  if (!a || !b) return std::nullopt;
  const Solution solution = solve(outlines, {(*a)[0], (*a)[1], (*b)[0], (*b)[1]});
  DiscOrientation disc;
  disc.radius_m = solution.m.norm();
  disc.normal_C = solution.m / disc.radius_m;
  disc.covariance_m2 = solution.covariance;
  disc.misfit = solution.misfit;
  if (!disc.normal_C.allFinite() || !std::isfinite(disc.misfit)) return std::nullopt;
  return disc;
}

}  // namespace mirrorarm::vision
