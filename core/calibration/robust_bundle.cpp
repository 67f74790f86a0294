#include "core/calibration/robust_bundle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/calibration/bundle_equations.h"
#include "core/calibration/disc_bias.h"
#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kRounds = 3;
constexpr double kHuber = 2.5;
constexpr double kOutlier = 5.0;
constexpr double kMedianOfRayleigh = 1.1774;  ///< median distance of a point whose axes have unit noise
constexpr double kLeastNoise_px = 2e-3;       ///< below that it is rounding and the lens model's
constexpr double kLeastSigmaShare = 0.5;      ///< of the median sigma: no point counts for many
constexpr std::size_t kFewestPoints = 4;

/// The views with a weight for every point: all known, or all alike.
std::vector<BoardView> weighted(std::span<const BoardView> views) {
  std::vector<BoardView> result(views.begin(), views.end());
  std::vector<double> sigmas;
  for (const auto& view : views)
    for (const auto& sighting : view.seen)
      for (const auto& seen : sighting) sigmas.push_back(seen.sigma_px);
  const bool all_known = std::ranges::all_of(sigmas, [](double sigma) { return sigma > 0.0; });
  const double least = all_known && !sigmas.empty() ? kLeastSigmaShare * median(sigmas) : 0.0;
  for (auto& view : result)
    for (auto& sighting : view.seen)
      for (auto& seen : sighting) seen.sigma_px = all_known ? std::max(seen.sigma_px, least) : 1.0;
  return result;
}

/// The views with the discs' own centres, as far as the bundle tells them.
std::vector<BoardView> centred(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                               std::span<const BoardView> views) {
  std::vector<camera::CameraModel> cameras(bundle.cameras.begin(), bundle.cameras.end());
  std::vector<PosedSighting> images;
  for (std::size_t v = 0; v < views.size(); ++v)
    for (std::size_t k = 0; k < cameras.size(); ++k)
      images.push_back({cameras[k], bundle.boardIn(k, v), views[v].seen[k]});
  const auto radii_m = discRadii(board, images);
  std::vector<BoardView> result(views.begin(), views.end());
  for (std::size_t i = 0; i < images.size(); ++i)
    result[i / cameras.size()].seen[i % cameras.size()] = physicalCentres(images[i], board, radii_m);
  return result;
}

/// Distances of all points from their projections [px], in the order of the sightings; infinite where a lens
/// model does not hold.
using Distances = std::vector<std::array<std::vector<double>, 2>>;
Distances distancesOf(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                      std::span<const BoardView> views) {
  Distances distances(views.size());
  for (std::size_t k = 0; k < bundle.cameras.size(); ++k) {
    const camera::CameraModel camera(bundle.cameras[k]);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const RigidTransform X_KM = bundle.boardIn(k, v);
      for (const auto& seen : views[v].seen[k]) {
        const auto pixel = camera.project(X_KM * board[static_cast<std::size_t>(seen.point)]);
        distances[v][k].push_back(pixel ? (*pixel - seen.pixel).norm()
                                        : std::numeric_limits<double>::infinity());
      }
    }
  }
  return distances;
}

std::vector<double> joined(const std::array<std::vector<double>, 2>& images) {
  std::vector<double> all = images[0];
  all.insert(all.end(), images[1].begin(), images[1].end());
  return all;
}

/// Noise of a point along an axis, in its standard deviations.
double noiseOf(const Distances& distances, std::span<const BoardView> views) {
  std::vector<double> shares;
  std::vector<double> sigmas;
  for (std::size_t v = 0; v < views.size(); ++v)
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < distances[v][k].size(); ++i) {
        const double sigma_px = views[v].seen[k][i].sigma_px;
        shares.push_back(distances[v][k][i] / sigma_px);
        sigmas.push_back(sigma_px);
      }
  return std::max(median(std::move(shares)) / kMedianOfRayleigh, kLeastNoise_px / median(std::move(sigmas)));
}

/// A sighting without the points that stray; whole when too few would remain, so that the view stays fixed.
Sighting withoutStrays(const Sighting& sighting, const std::vector<double>& distances, double noise) {
  Sighting kept;
  for (std::size_t i = 0; i < sighting.size(); ++i)
    if (distances[i] <= kOutlier * noise * sighting[i].sigma_px) kept.push_back(sighting[i]);
  return kept.size() < std::max(kFewestPoints, sighting.size() / 2) ? sighting : kept;
}

void leaveOutStrays(const Distances& distances, double noise, std::vector<BoardView>& views) {
  for (std::size_t v = 0; v < views.size(); ++v)
    for (std::size_t k = 0; k < 2; ++k)
      views[v].seen[k] = withoutStrays(views[v].seen[k], distances[v][k], noise);
}

double rms(const std::vector<double>& distances) {
  double squares = 0.0;
  for (const double d : distances) squares += d * d;
  return std::sqrt(squares / static_cast<double>(distances.size()));
}

void judge(const Distances& all, std::span<const Eigen::Vector3d> board, RobustFit& fit) {
  const auto distances = distancesOf(fit.bundle, board, fit.used);
  std::vector<double> together;
  for (std::size_t v = 0; v < fit.used.size(); ++v) {
    const auto used = joined(distances[v]);
    const auto given = joined(all[v]);
    fit.outlier_points.push_back(static_cast<int>(given.size() - used.size()));
    fit.misfit_px.push_back(median(given));
    fit.rms_px.push_back(rms(used));
    together.insert(together.end(), used.begin(), used.end());
  }
  fit.total_rms_px = rms(together);
}

void weigh(std::span<const Eigen::Vector3d> board, RobustFit& fit) {
  const auto equations = normalEquations(fit.bundle, board, fit.used);
  if (!equations) return;
  const double freedom =
      2.0 * static_cast<double>(equations->points) - static_cast<double>(equations->gradient.size());
  if (freedom <= 0.0) return;
  fit.variance_factor = equations->squares / freedom;
  const auto shared = reduced(*equations, sharedTerms(fit.bundle));
  if (!shared) return;
  fit.covariance = inverseOf(shared->matrix);
  if (fit.covariance) *fit.covariance *= fit.variance_factor;
}

}  // namespace

std::optional<RobustFit> fitRobustly(const Bundle& start, std::span<const Eigen::Vector3d> board,
                                     std::span<const BoardView> views) {
  const auto given = weighted(views);
  auto adjusted = adjustBundle(start, board, given);
  RobustFit fit;
  std::vector<BoardView> centres;
  for (int round = 0; adjusted && round < kRounds; ++round) {
    centres = centred(adjusted->bundle, board, given);
    fit.used = centres;
    const auto distances = distancesOf(adjusted->bundle, board, centres);
    const double noise = noiseOf(distances, centres);
    leaveOutStrays(distances, noise, fit.used);
    adjusted = adjustBundle(adjusted->bundle, board, fit.used, {kHuber * noise});
  }
  if (!adjusted) return std::nullopt;
  fit.bundle = std::move(adjusted->bundle);
  judge(distancesOf(fit.bundle, board, centres), board, fit);
  weigh(board, fit);
  return fit;
}

}  // namespace mirrorarm::calibration
