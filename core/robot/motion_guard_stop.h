#pragma once

#include <array>

#include <Eigen/Core>

namespace mirrorarm::robot {

/// How an arm comes to rest, in whole cycles that all joints share: accelerations fall evenly to zero
/// (`release`), go evenly to each joint's plateau (`ramp_in`), stay there (`hold`) and fall evenly to zero
/// (`ramp_out`), when the speed is zero as well. The plateau follows from speed and acceleration, so that
/// what is left of a stop is again a stop from where the arm is then.
struct Stop {
  int release = 0;
  int ramp_in = 0;
  int hold = 0;
  int ramp_out = 0;

  [[nodiscard]] int cycles() const { return release + ramp_in + hold + ramp_out; }
  /// What is left after one cycle.
  [[nodiscard]] Stop afterOneCycle() const;
};

/// Anything that speed v and acceleration a of the start enter evenly: number of v, number of a.
using Share = Eigen::Array2d;

/// Where a stop is after some cycles, for every joint and for every other quantity that moves with the
/// joints evenly: displacement = displacement[0] * v + displacement[1] * a, and so on.
struct Moment {
  Share displacement{0.0, 0.0};
  Share speed{1.0, 0.0};
  Share acceleration{0.0, 1.0};
};

/// A stop, cycle by cycle, exactly as the differences of the wire's positions see it.
class StopCourse {
 public:
  StopCourse(const Stop& stop, double period_s);

  [[nodiscard]] const Moment& released() const { return released_; }
  [[nodiscard]] const Moment& atPlateau() const { return at_plateau_; }
  [[nodiscard]] const Moment& atRampOut() const { return at_ramp_out_; }
  [[nodiscard]] const Moment& atRest() const { return at_rest_; }
  /// After its first cycle.
  [[nodiscard]] const Moment& next() const { return next_; }
  /// In the middle of its parts and at their ends, those of no length left out.
  static constexpr int kSamples = 9;
  template <class Look>
  [[nodiscard]] bool allOf(Look look) const {
    for (int i = 0; i < sample_count_; ++i)
      if (!look(samples_[static_cast<std::size_t>(i)])) return false;
    return true;
  }

 private:
  Moment part(Moment from, Share step, int cycles, int samples);
  void keep(const Moment& moment) { samples_[static_cast<std::size_t>(sample_count_++)] = moment; }

  double period_s_;
  Moment next_, released_, at_plateau_, at_ramp_out_, at_rest_;
  std::array<Moment, kSamples> samples_;
  int sample_count_ = 0;
  bool has_next_ = false;
};

}  // namespace mirrorarm::robot
