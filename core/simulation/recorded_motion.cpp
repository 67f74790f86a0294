#include "core/simulation/recorded_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/geometry/rigid_fit.h"
#include "core/simulation/smooth_ramp.h"

namespace mirrorarm::simulation {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::array<std::string_view, 10> kMarkers{"EPICl",    "EPICm", "LARMm",    "LARMl", "LARM_elb",
                                                    "LARM_ant", "STYLr", "STYLr_up", "STYLu", "WRIST"};
constexpr std::size_t kEpicl = 0, kEpicm = 1, kStylr = 6, kStylu = 8;
constexpr double kMostTurn_rad = 0.61;
constexpr double kTurningRamp_s = 0.25;

ArmMotion::Forearm forearmOf(const Points& markers) {
  return {0.5 * (markers[kEpicl] + markers[kEpicm]), 0.5 * (markers[kStylr] + markers[kStylu])};
}

/// From the axis of the forearm square to the marker.
Eigen::Vector3d outwards(const ArmMotion::Forearm& forearm, const Eigen::Vector3d& marker) {
  const Eigen::Vector3d axis = (forearm.wrist_B - forearm.elbow_B).normalized();
  const Eigen::Vector3d away = marker - forearm.elbow_B;
  return away - axis.dot(away) * axis;
}

/// Frame A of the recording's first sample; nothing when elbow and wrist coincide or no side carries the
/// markers.
std::optional<RigidTransform> startFrame(const Points& markers) {
  constexpr double kLeast_m = 1e-3;
  const auto forearm = forearmOf(markers);
  const Eigen::Vector3d along = forearm.wrist_B - forearm.elbow_B;
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  for (const auto& marker : markers) side += outwards(forearm, marker) / static_cast<double>(markers.size());
  if (!(along.norm() > kLeast_m) || !(side.norm() > kLeast_m)) return std::nullopt;
  Eigen::Matrix3d R;
  R.col(0) = along.normalized();
  R.col(2) = side.normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  return makeTransform(R, 0.5 * (forearm.elbow_B + forearm.wrist_B));
}

/// Smallest angle between two markers as one of the cameras sees them, over the whole recording.
double closestView(const MarkerMotion& motion, const RigidTransform& X_BW,
                   const RecordedMotion::CameraPositions& cameras_B) {
  constexpr std::size_t kEvery = 5;
  double most_alike = -1.0;
  std::array<Eigen::Vector3d, kMarkers.size()> sight;
  for (std::size_t i = 0; i < motion.positions_m.size(); i += kEvery)
    for (const auto& camera_B : cameras_B)
      for (std::size_t k = 0; k < kMarkers.size(); ++k) {
        sight[k] = (X_BW * motion.positions_m[i][k] - camera_B).normalized();
        for (std::size_t j = 0; j < k; ++j) most_alike = std::max(most_alike, sight[k].dot(sight[j]));
      }
  return std::acos(std::min(most_alike, 1.0));
}

/// Where the recording's frame W goes.
RigidTransform placement(const MarkerMotion& motion, const RigidTransform& X_BA, const RigidTransform& X_WA,
                         const RecordedMotion::CameraPositions& cameras_B) {
  constexpr double kMost_deg = 60.0, kStep_deg = 3.0;
  RigidTransform best = X_BA * X_WA.inverse();
  double widest = -1.0;
  for (double roll_deg = -kMost_deg; roll_deg <= kMost_deg; roll_deg += kStep_deg) {
    const Eigen::AngleAxisd roll(roll_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitX());
    const RigidTransform X_BW = X_BA * roll * X_WA.inverse();
    const double angle = closestView(motion, X_BW, cameras_B);
    if (angle <= widest) continue;
    widest = angle;
    best = X_BW;
  }
  return best;
}

/// `from` turned towards `to` by at most `most_rad`; both of length 1.
Eigen::Vector3d turnedTowards(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double most_rad) {
  const double angle = std::acos(std::clamp(from.dot(to), -1.0, 1.0));
  const Eigen::Vector3d axis = from.cross(to);
  if (axis.norm() < 1e-9) return from;
  return Eigen::AngleAxisd(std::min(angle, most_rad), axis.normalized()) * from;
}

/// Time in a pass of `length_s` that is played forth and back for ever, slowing down at both ends.
double toAndFro(double phase_s, double length_s) {
  const double ramp_s = std::min(kTurningRamp_s, length_s);
  const double pass_s = length_s + ramp_s;
  const double place = std::fmod(std::max(phase_s, 0.0), 2.0 * pass_s);
  const double forth = place < pass_s ? place : 2.0 * pass_s - place;
  return ramp_s * (smoothRampIntegral(forth / ramp_s) - smoothRampIntegral((forth - length_s) / ramp_s));
}

Eigen::Vector3d catmullRom(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           const Eigen::Vector3d& d, double t) {
  return b + 0.5 * t * ((c - a) + t * ((2.0 * a - 5.0 * b + 4.0 * c - d) + t * (3.0 * (b - c) + d - a)));
}

}  // namespace

FromFile<RecordedMotion> RecordedMotion::read(const std::filesystem::path& file, const RigidTransform& X_BA,
                                              const CameraPositions& cameras_B) {
  auto motion = readTrc(file, kMarkers);
  if (!motion) return unexpected(motion.error());
  const auto X_WA = startFrame(motion->positions_m.front());
  if (!X_WA)
    return unexpected(FileError{file, 0, "elbow and wrist markers of the first frame give no forearm"});
  const RigidTransform X_BW = placement(*motion, X_BA, *X_WA, cameras_B);
  for (auto& sample : motion->positions_m)
    for (auto& marker : sample) marker = X_BW * marker;
  return RecordedMotion(std::move(*motion), cameras_B);
}

RecordedMotion::RecordedMotion(MarkerMotion motion_B, const CameraPositions& cameras_B)
    : motion_B_(std::move(motion_B)) {
  const Points& start = motion_B_.positions_m.front();
  const auto forearm = forearmOf(start);
  const Eigen::Vector3d camera_B = 0.5 * (cameras_B[0] + cameras_B[1]);
  for (const auto& marker : start)
    start_normals_B_.push_back(turnedTowards((camera_B - marker).normalized(),
                                             outwards(forearm, marker).normalized(), kMostTurn_rad));
}

Points RecordedMotion::markersAt(double phase_s) const {
  const auto& samples = motion_B_.positions_m;
  const auto last = static_cast<std::ptrdiff_t>(samples.size()) - 1;
  const double place = toAndFro(phase_s, static_cast<double>(last) / motion_B_.rate_hz) * motion_B_.rate_hz;
  const auto below = std::clamp(static_cast<std::ptrdiff_t>(place), std::ptrdiff_t{0}, last - 1);
  const auto sample = [&](std::ptrdiff_t i) -> const Points& {
    return samples[static_cast<std::size_t>(std::clamp(i, std::ptrdiff_t{0}, last))];
  };
  Points markers;
  for (std::size_t k = 0; k < kMarkers.size(); ++k)
    markers.push_back(catmullRom(sample(below - 1)[k], sample(below)[k], sample(below + 1)[k],
                                 sample(below + 2)[k], place - static_cast<double>(below)));
  return markers;
}

int RecordedMotion::discCount() const { return static_cast<int>(kMarkers.size()); }

void RecordedMotion::discsAt(double phase_s, std::span<Disc> discs) const {
  const Points markers = markersAt(phase_s);
  const auto moved = fitByKabsch(motion_B_.positions_m.front(), markers);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    discs[i].p_B = markers[i];
    discs[i].normal_B = moved.linear() * start_normals_B_[i];
    discs[i].diameter_m = Disc{}.diameter_m;
  }
}

ArmMotion::Forearm RecordedMotion::forearmAt(double phase_s) const { return forearmOf(markersAt(phase_s)); }

}  // namespace mirrorarm::simulation
