#include "core/vision/centre_correction.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace mirrorarm::vision {
namespace {

constexpr int kChords = 3;
constexpr int kDirections = 8;

/// Unit vectors over half a turn.
template <std::size_t kCount>
std::array<Eigen::Vector2d, kCount> halfTurn() {
  std::array<Eigen::Vector2d, kCount> directions;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / kCount;
    directions[i] = {std::cos(angle), std::sin(angle)};
  }
  return directions;
}

/// The disc's outline in the image, chord by chord through its centre, with (c, s) the direction in the disc:
/// ends at centre + middle +- half, where half = axes (c, s) and middle = even + twice_c (c^2 - s^2) +
/// twice_s 2 c s, to fourth order of the radius.
struct Chords {
  Eigen::Matrix2d axes = Eigen::Matrix2d::Zero();
  Eigen::Vector2d even = Eigen::Vector2d::Zero();
  Eigen::Vector2d twice_c = Eigen::Vector2d::Zero();
  Eigen::Vector2d twice_s = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d middle(const Eigen::Vector2d& d) const {
    return even + (d.x() * d.x() - d.y() * d.y()) * twice_c + 2.0 * d.x() * d.y() * twice_s;
  }
};

/// Three chords hold all that their description needs.
std::optional<Chords> chordsOf(const camera::CameraModel& camera, const FlatDisc& disc,
                               const Eigen::Vector2d& centre_px) {
  static const auto directions = halfTurn<kChords>();
  const Eigen::Vector3d u = disc.radius_m * disc.normal_K.unitOrthogonal();
  const Eigen::Vector3d v = disc.normal_K.cross(u);
  Chords chords;
  for (const auto& d : directions) {
    const Eigen::Vector3d half = d.x() * u + d.y() * v;
    const auto one = camera.project(disc.p_K + half);
    const auto other = camera.project(disc.p_K - half);
    if (!one || !other) return std::nullopt;
    const Eigen::Vector2d middle = (0.5 * (*one + *other) - centre_px) / kChords;
    chords.axes += (*one - *other) * d.transpose() / kChords;
    chords.even += middle;
    chords.twice_c += 2.0 * (d.x() * d.x() - d.y() * d.y()) * middle;
    chords.twice_s += 4.0 * d.x() * d.y() * middle;
  }
  return chords;
}

}  // namespace

std::optional<Eigen::Vector2d> centreBias(const camera::CameraModel& camera, const FlatDisc& disc) {
  const auto centre_px = camera.project(disc.p_K);
  if (!centre_px) return std::nullopt;
  return centreBias(camera, disc, *centre_px);
}

std::optional<Eigen::Vector2d> centreBias(const camera::CameraModel& camera, const FlatDisc& disc,
                                          const Eigen::Vector2d& centre_px) {
  static const auto directions = halfTurn<kDirections>();
  const auto chords = chordsOf(camera, disc, centre_px);
  if (!chords) return std::nullopt;
  // Turning and stretching an ellipse moves both ends of a chord alike inwards or outwards; only its shift
  // moves their middle. So the five unknowns of the fit fall apart, and the shift has its own 2x2 system:
  // middles against the outline's normals, weighted by its length.
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d vector = Eigen::Vector2d::Zero();
  for (const auto& d : directions) {
    const Eigen::Vector2d tangent = chords->axes * Eigen::Vector2d(-d.y(), d.x());
    const Eigen::Vector2d normal(-tangent.y(), tangent.x());
    const Eigen::Vector2d weighted = normal / tangent.norm();
    matrix += weighted * normal.transpose();
    vector += weighted * normal.dot(chords->middle(d));
  }
  const Eigen::Vector2d bias = matrix.inverse() * vector;
  if (!bias.allFinite()) return std::nullopt;
  return bias;
}

Eigen::Vector2d physicalCentre(const camera::CameraModel& camera, const Eigen::Vector2d& fitted_px,
                               const FlatDisc& disc) {
  const auto bias = centreBias(camera, disc);
  return bias ? Eigen::Vector2d(fitted_px - *bias) : fitted_px;
}

}  // namespace mirrorarm::vision
