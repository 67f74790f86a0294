#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/geometry/rigid_fit.h"
#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking::test {

using Eigen::Vector3d;

/// What the skin of a simulated forearm does. Shares of one size, which best_fit_rms_m sets.
struct SkinMotion {
  double best_fit_rms_m = 0.005;  ///< mean over time of the misfit that the best rigid pose leaves
  double twist = 1.0;             ///< with pro- and supination, growing along the arm as the square
  double bulge = 0.6;             ///< of the muscle's belly with flexion
  double looseness = 0.06;        ///< of each marker by itself
  double twist_Hz = 0.35;
  double bulge_Hz = 0.7;
};

/// One frame of it, and for the test alone what each point is.
struct SkinFrame {
  double time_s = 0.0;
  RigidTransform X_CB = RigidTransform::Identity();  ///< the bone, truly
  std::vector<CloudPoint> cloud;
  std::vector<int> marker_of_point;  ///< -1 a stranger
  std::vector<char> hidden;          ///< a flag for each marker
};

/// A forearm (bone B: x from the elbow to the wrist) with ten markers on skin that moves against it, before a
/// camera C. Everything follows from the seed and the time.
class SimulatedSkin {
 public:
  static constexpr int kMarkers = 10;
  static constexpr double kFrame_s = 1.0 / 24.0;

  SimulatedSkin(const SkinMotion& motion, unsigned seed) : motion_(motion), rng_(seed) {
    const double along_m[] = {-0.073, -0.059, -0.040, -0.026, -0.007, 0.009, 0.022, 0.040, 0.058, 0.077};
    const double around_deg[] = {10, 95, 160, 55, 120, 20, 75, 150, 40, 105};
    for (int i = 0; i < kMarkers; ++i) {
      const double angle = around_deg[i] * std::numbers::pi / 180.0;
      const double radius = 0.045 - 0.1 * (along_m[i] + 0.073);
      rest_B_.emplace_back(along_m[i], radius * std::cos(angle), radius * std::sin(angle));
      for (int wave = 0; wave < 3; ++wave)
        waves_.push_back({gaussian(), 0.2 + 0.5 * uniform(), 6.3 * uniform()});
      loose_.push_back(0.3 + 1.4 * uniform() * uniform());
    }
    for (int round = 0; round < 4 && motion.best_fit_rms_m > 0.0; ++round)
      size_m_ *= motion.best_fit_rms_m / meanBestFit();
    if (motion.best_fit_rms_m <= 0.0) size_m_ = 0.0;
  }

  /// Bone in camera: 0.7 Hz, 120 mm from end to end, turning; up to 0.26 m/s.
  [[nodiscard]] static RigidTransform bone(double t) {
    const double phase = 2.0 * std::numbers::pi * 0.7 * t;
    const Vector3d turn(0.25 * std::sin(0.6 * phase), 0.4 * std::sin(phase), 0.2 * std::cos(0.8 * phase));
    return makeTransform(
        Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())),
        Vector3d(0.06 * std::sin(phase), 0.02 * std::cos(phase), 0.45 + 0.02 * std::sin(phase)));
  }

  /// A marker on the skin, in B.
  [[nodiscard]] Vector3d marker(int i, double t) const {
    const auto at = static_cast<std::size_t>(i);
    Vector3d p = rest_B_[at] + slipped_[at];
    const double along = (p.x() + 0.073) / 0.150;
    const double twist_rad = motion_.twist * size_m_ / 0.02 * along * along * wave(motion_.twist_Hz, t);
    p = Eigen::AngleAxisd(twist_rad, Vector3d::UnitX()) * p;
    const Vector3d outwards = Vector3d(0.0, p.y(), p.z()).normalized();
    const double belly = std::exp(-0.5 * std::pow((along - 0.35) / 0.2, 2));
    p += motion_.bulge * size_m_ * belly *
         (wave(motion_.bulge_Hz, t) * outwards + 0.3 * wave(motion_.twist_Hz, t + 0.4) * Vector3d::UnitX());
    for (std::size_t w = 3 * at; w < 3 * at + 3; ++w)
      p += motion_.looseness * size_m_ * loose_[at] *
           std::sin(6.283 * waves_[w].frequency_Hz * t + waves_[w].phase) * waves_[w].direction;
    return p;
  }

  /// The sleeve slips: from now on the markers from `first` on stand turned about the arm, farther along
  /// more, the last by `distance_m`.
  void slip(int first, double distance_m) {
    for (auto i = static_cast<std::size_t>(first); i < rest_B_.size(); ++i) {
      const double share = 0.5 + 0.5 * static_cast<double>(i) / (kMarkers - 1);
      slipped_[i] += distance_m * share * Vector3d::UnitX().cross(rest_B_[i]).normalized();
    }
  }

  /// What the target would be taught as at time `t`: the skin as it is then, in B.
  [[nodiscard]] Target taughtAt(double t) const {
    Target target;
    target.name = "forearm";
    for (int i = 0; i < kMarkers; ++i) target.markers_T.push_back(marker(i, t));
    return target;
  }

  /// The frame at `t`: markers that are not `hidden` and `strangers` anywhere about the arm, shuffled.
  [[nodiscard]] SkinFrame look(double t, const std::vector<char>& hidden, int strangers) {
    SkinFrame frame{t, bone(t), {}, {}, hidden};
    for (int i = 0; i < kMarkers; ++i)
      if (hidden[static_cast<std::size_t>(i)] == 0) add(frame, i, frame.X_CB * marker(i, t));
    for (int i = 0; i < strangers; ++i)
      add(frame, -1, frame.X_CB.translation() + 0.15 * Vector3d(side(), side(), side()));
    return frame;
  }
  /// Puts one more point in, at a random place in the order.
  void add(SkinFrame& frame, int marker, const Vector3d& p_C) {
    const auto at = static_cast<std::ptrdiff_t>(uniform() * static_cast<double>(frame.cloud.size() + 1));
    frame.cloud.insert(frame.cloud.begin() + at, measured(p_C));
    frame.marker_of_point.insert(frame.marker_of_point.begin() + at, marker);
  }

  /// A marker as the sensor measures it: 0.01, 0.01, 0.05 mm.
  [[nodiscard]] CloudPoint measured(const Vector3d& p_C) {
    const Vector3d sigma_m(1e-5, 1e-5, 5e-5);
    CloudPoint point;
    point.p_C = p_C + sigma_m.cwiseProduct(gaussian());
    point.covariance_m2 = sigma_m.cwiseAbs2().asDiagonal();
    return point;
  }

  /// Mean over half a minute of the rms of the best rigid fit to the shape at rest [m].
  [[nodiscard]] double meanBestFit() const {
    double sum = 0.0;
    constexpr int kFrames = 300;
    for (int frame = 0; frame < kFrames; ++frame) sum += bestFit(0.1 * frame) / kFrames;
    return sum;
  }
  [[nodiscard]] double bestFit(double t) const {
    std::vector<Vector3d> now;
    for (int i = 0; i < kMarkers; ++i) now.push_back(marker(i, t));
    return fitRms(fitByKabsch(rest_B_, now), rest_B_, now);
  }

  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(rng_); }
  Vector3d gaussian() {
    std::normal_distribution<double> d(0.0, 1.0);
    return {d(rng_), d(rng_), d(rng_)};
  }
  std::mt19937& random() { return rng_; }

 private:
  double side() { return 2.0 * uniform() - 1.0; }
  struct Wave {
    Vector3d direction;
    double frequency_Hz, phase;
  };
  [[nodiscard]] static double wave(double frequency_Hz, double t) {
    return std::sin(2.0 * std::numbers::pi * frequency_Hz * t);
  }

  SkinMotion motion_;
  std::mt19937 rng_;
  double size_m_ = 0.01;
  std::vector<Vector3d> rest_B_;
  std::vector<Vector3d> slipped_ = std::vector<Vector3d>(kMarkers, Vector3d::Zero());
  std::vector<Wave> waves_;
  std::vector<double> loose_;
};

}  // namespace mirrorarm::tracking::test
