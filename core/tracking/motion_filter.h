#pragma once

#include <array>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// How a limb may be moving for a while: it rests, glides on at its velocity, or swings, its jerk being
/// -frequency^2 * velocity (at frequency 0: constant acceleration), each with white noise.
struct MotionModel {
  enum class Kind { kRest, kGlide, kSwing };
  Kind kind = Kind::kSwing;
  double frequency_rad_s = 0.0;
  /// Spectral density of what the model does not know: of the velocity at rest [m^2/s], of the acceleration
  /// of a glide [m^2/s^3], of the jerk of a swing [m^2/s^5].
  double noise = 0.0;
  double jitter_m = 0.0;  ///< deviation of a measurement beyond its own: skin, the target's model
};

/// Follows a point of a limb by several motion models at once and weighs them by how well each foretold what
/// was measured lately: an interacting multiple model filter, with position, velocity and acceleration in
/// each model and axis. The axes share the models' weights: a limb stops as a whole. The models span an arm's
/// rest, slow glides, sudden changes, and swings of 0.4 to 2 Hz. Fixed size, no heap, one thread.
/// Source: Blom and Bar-Shalom, IEEE Trans. Automatic Control 33(8), 1988.
class MotionFilter {
 public:
  static constexpr std::size_t kModels = 11;

  struct Prediction {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  };

  /// The models are of an arm in metres; `unit` is how many units of the measured quantity a metre amounts
  /// to: 1 for a place in metres, some rad/m for a turn.
  explicit MotionFilter(double unit) : unit_(unit) {}

  /// Begins anew, knowing nothing about the motion.
  void start(const Eigen::Vector3d& position, const Eigen::Vector3d& variance);
  /// A measurement `step_s` > 0 after the last one with the `variance` of each axis.
  void add(double step_s, const Eigen::Vector3d& position, const Eigen::Vector3d& variance);
  /// Where the point is `step_s` after the last measurement, or a little before it. The covariance is that of
  /// the models and of what none of them foresees: a sudden stop or start within the step.
  [[nodiscard]] Prediction at(double step_s) const;
  /// Measures all positions from `origin` from now on.
  void moveOrigin(const Eigen::Vector3d& origin);

 private:
  struct Axis {
    Eigen::Vector3d state = Eigen::Vector3d::Zero();  ///< position, velocity, acceleration
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  };
  using Body = std::array<Axis, 3>;
  using Shares = std::array<double, kModels>;

  void mix(double step_s);
  [[nodiscard]] Axis mixed(std::size_t axis, const Shares& parts) const;
  void predict(double step_s);
  /// How well model `j` foretold the measurement: log likelihood; takes it over.
  [[nodiscard]] double update(std::size_t j, const Eigen::Vector3d& position,
                              const Eigen::Vector3d& variance);
  [[nodiscard]] double unforeseenVariance(double step_s) const;

  double unit_;
  std::array<Body, kModels> bodies_{};
  Shares shares_{};  ///< how likely each model is; sums to 1
};

}  // namespace mirrorarm::tracking
