#pragma once

#include <span>
#include <vector>

#include "core/tracking/skin_model.h"
#include "core/tracking/warm_registration.h"

namespace mirrorarm::tracking::test {

/// The smallest tracker there can be about a skin model: it starts from a known pose, carries it on at its
/// velocity, and tries a frame that did not fit once more after the model has had a look at it.
class SkinLoop {
 public:
  SkinLoop(const Target& taught, const RigidTransform& X_CT_before, const RigidTransform& X_CT_last,
           const SkinSettings& settings = {})
      : skin(taught, settings), registration(warm()), X_CT(X_CT_last), X_before_(X_CT_before) {}

  /// True when the target was tracked in this frame.
  bool track(std::span<const CloudPoint> cloud, TimePoint time, std::span<const char> in_view = {}) {
    skin.predict(time);
    UncertainPose guess;
    guess.X_CT = X_CT * (X_before_.inverse() * X_CT);
    guess.covariance.diagonal() << kTurn * kTurn, kTurn * kTurn, kTurn * kTurn, kShift * kShift,
        kShift * kShift, kShift * kShift;
    taken_.assign(cloud.size(), 0);
    event = SkinEvent::kNone;
    fit = &registration.run(shape(), cloud, guess);
    const bool was_misfit = !fit->isAccepted();
    if (was_misfit) {
      ++misfits;
      event = skin.observeMisfit({time, guess.X_CT, cloud, {}, taken_, in_view});
      if (skin.foundPose()) guess.X_CT = *skin.foundPose();
      fit = &registration.run(shape(), cloud, guess);
    }
    if (!fit->isAccepted()) return false;
    // A slip is no motion of the arm: its velocity goes on.
    const RigidTransform X_back = X_CT.inverse() * X_before_;
    X_before_ = X_CT;
    X_CT = makeTransform(rotationOf(fit->pose.X_CT), fit->pose.X_CT.translation());
    if (was_misfit) X_before_ = X_CT * X_back;
    const SkinEvent seen = skin.observe({time, X_CT, cloud, fit->point_of_marker, taken_, in_view});
    if (event == SkinEvent::kNone) event = seen;
    return true;
  }

  SkinModel skin;
  WarmRegistration registration;
  RigidTransform X_CT;
  const ShapeFit* fit = nullptr;  ///< of the last frame
  SkinEvent event = SkinEvent::kNone;
  int misfits = 0;

 private:
  static constexpr double kTurn = 0.01, kShift = 0.0015;
  static WarmSettings warm() {
    WarmSettings settings;
    settings.min_matched = 4;
    return settings;
  }
  [[nodiscard]] Shape shape() const { return {skin.shape_T(), skin.covariance_m2(), skin.present()}; }

  RigidTransform X_before_;
  std::vector<char> taken_;
};

}  // namespace mirrorarm::tracking::test
