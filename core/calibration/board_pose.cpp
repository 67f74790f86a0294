#include "core/calibration/board_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "core/calibration/disc_bias.h"
#include "core/calibration/planar_pose.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kFewestPoints = 4;
constexpr int kMostSteps = 50;
constexpr int kDiscRounds = 2;  ///< a disc's bias changes the pose by less than the bias by far
constexpr double kLargestDamping = 1e8;
constexpr double kSettledShare = 1e-12;
constexpr double kLeastCondition = 1e-12;  ///< of the normal equations, scaled to a unit diagonal

/// One image of the board and the way to its camera.
struct Image {
  std::size_t k;  ///< 0 left, 1 right
  const camera::CameraModel* camera;
  RigidTransform X_KC;
  Sighting sighting;
};

struct Equations {
  Matrix6 normal = Matrix6::Zero();
  SmallMotion gradient = SmallMotion::Zero();
  double squares = 0.0;  ///< weighted
  double squares_px2 = 0.0;
};

/// The points of all images as one least squares problem in the board's pose.
class PoseProblem {
 public:
  PoseProblem(std::span<const Eigen::Vector3d> board, const std::vector<Image>& images)
      : board_(board), images_(images) {
    for (const auto& image : images)
      for (const auto& seen : image.sighting) {
        ++points_;
        knows_sigma_ = knows_sigma_ && seen.sigma_px > 0.0;
      }
  }

  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] bool knowsSigma() const { return knows_sigma_; }

  /// Nothing where a point cannot be projected.
  [[nodiscard]] std::optional<Equations> at(const RigidTransform& X_CM) const {
    Equations sums;
    for (const auto& image : images_) {
      const RigidTransform X_KM = image.X_KC * X_CM;
      for (const auto& seen : image.sighting)
        if (!add(image, X_KM, seen, sums)) return std::nullopt;
    }
    return sums;
  }

 private:
  [[nodiscard]] bool add(const Image& image, const RigidTransform& X_KM, const SeenPoint& seen,
                         Equations& sums) const {
    const auto& p_M = board_[static_cast<std::size_t>(seen.point)];
    camera::CameraModel::ProjectJacobian by_point;
    const auto pixel = image.camera->project(X_KM * p_M, by_point);
    if (!pixel) return false;
    const double weight = knows_sigma_ ? 1.0 / (seen.sigma_px * seen.sigma_px) : 1.0;
    const Eigen::Vector2d residual = *pixel - seen.pixel;
    const Eigen::Matrix<double, 2, 6> J = by_point * X_KM.linear() * motionAt(p_M);
    sums.normal.noalias() += weight * J.transpose() * J;
    sums.gradient.noalias() += weight * J.transpose() * residual;
    sums.squares += weight * residual.squaredNorm();
    sums.squares_px2 += residual.squaredNorm();
    return true;
  }

  std::span<const Eigen::Vector3d> board_;
  const std::vector<Image>& images_;
  std::size_t points_ = 0;
  bool knows_sigma_ = true;
};

struct Fit {
  RigidTransform X_CM;
  Equations equations;
};

/// Levenberg and Marquardt's step that makes the fit better; false when none is left.
bool improve(const PoseProblem& problem, Fit& fit, double& damping) {
  for (; damping < kLargestDamping; damping *= 10.0) {
    Matrix6 damped = fit.equations.normal;
    damped.diagonal() *= 1.0 + damping;
    const SmallMotion step = -damped.ldlt().solve(fit.equations.gradient);
    if (!step.allFinite()) return false;
    const RigidTransform X_CM = moved(fit.X_CM, step);
    const auto next = problem.at(X_CM);
    if (!next || !(next->squares < fit.equations.squares)) continue;
    const bool goes_on = fit.equations.squares - next->squares > kSettledShare * fit.equations.squares;
    fit = {X_CM, *next};
    damping = std::max(0.1 * damping, 1e-12);
    return goes_on;
  }
  return false;
}

std::optional<Fit> refined(const PoseProblem& problem, const RigidTransform& start) {
  const auto equations = problem.at(start);
  if (!equations) return std::nullopt;
  Fit fit{start, *equations};
  double damping = 1e-3;
  for (int i = 0; i < kMostSteps; ++i)
    if (!improve(problem, fit, damping)) break;
  return fit;
}

std::optional<Fit> bestFrom(const PoseProblem& problem, std::span<const RigidTransform> starts) {
  std::optional<Fit> best;
  for (const auto& start : starts) {
    auto fit = refined(problem, start);
    if (fit && (!best || fit->equations.squares < best->equations.squares)) best = std::move(fit);
  }
  return best;
}

std::vector<Image> imagesOf(const camera::StereoRig& rig, const BoardView& view) {
  std::vector<Image> images;
  if (!view.seen[0].empty()) images.push_back({0, &rig.left, RigidTransform::Identity(), view.seen[0]});
  if (!view.seen[1].empty()) images.push_back({1, &rig.right, rig.X_RC, view.seen[1]});
  return images;
}

/// Poses by the image that shows most.
std::vector<RigidTransform> startsFrom(const std::vector<Image>& images,
                                       std::span<const Eigen::Vector3d> board) {
  const auto fullest = std::max_element(images.begin(), images.end(), [](const Image& a, const Image& b) {
    return a.sighting.size() < b.sighting.size();
  });
  if (fullest == images.end() || fullest->sighting.size() < kFewestPoints) return {};
  auto poses = planarPoses(*fullest->camera, board, fullest->sighting);
  for (auto& pose : poses) pose = fullest->X_KC.inverse() * pose;
  return poses;
}

void freeOfBias(std::vector<Image>& images, const BoardView& view, std::span<const Eigen::Vector3d> board,
                const RigidTransform& X_CM) {
  std::vector<PosedSighting> posed;
  for (const auto& image : images) posed.push_back({*image.camera, image.X_KC * X_CM, view.seen[image.k]});
  const auto radii_m = discRadii(board, posed);
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i].sighting = physicalCentres(posed[i], board, radii_m);
}

bool showsDiscs(const BoardView& view) {
  return std::ranges::any_of(view.seen, [](const Sighting& sighting) {
    return std::ranges::any_of(sighting, [](const SeenPoint& seen) { return !seen.shape_px2.isZero(); });
  });
}

/// Nothing where the points do not fix the pose.
std::optional<Matrix6> covarianceOf(const PoseProblem& problem, const Equations& equations) {
  const Eigen::Matrix<double, 6, 1> scale = equations.normal.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  const Matrix6 scaled = scale.asDiagonal() * equations.normal * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(scaled);
  if (!(eigen.eigenvalues()[0] > kLeastCondition * eigen.eigenvalues()[5])) return std::nullopt;
  const double freedom = 2.0 * static_cast<double>(problem.points()) - 6.0;
  const double misfit = equations.squares / freedom;
  const double factor = problem.knowsSigma() ? std::max(1.0, misfit) : misfit;
  return factor * scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
}

BoardView centresOf(const BoardView& view, const std::vector<Image>& images) {
  BoardView centres = view;
  for (const auto& image : images) centres.seen[image.k] = image.sighting;
  return centres;
}

}  // namespace

std::optional<BoardPose> poseBoard(const camera::StereoRig& rig, const Board& board, const BoardView& view) {
  const auto points = boardPoints(board);
  auto images = imagesOf(rig, view);
  auto fit = bestFrom(PoseProblem(points, images), startsFrom(images, points));
  if (!fit) return std::nullopt;
  for (int round = 0; showsDiscs(view) && round < kDiscRounds; ++round) {
    freeOfBias(images, view, points, fit->X_CM);
    fit = refined(PoseProblem(points, images), fit->X_CM);
    if (!fit) return std::nullopt;
  }
  const PoseProblem problem(points, images);
  const auto covariance = covarianceOf(problem, fit->equations);
  if (!covariance) return std::nullopt;
  const double rms_px = std::sqrt(fit->equations.squares_px2 / static_cast<double>(problem.points()));
  return BoardPose{fit->X_CM, *covariance, rms_px, centresOf(view, images)};
}

}  // namespace mirrorarm::calibration
