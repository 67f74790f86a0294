#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::simulation {

/// A flat retroreflective disc.
struct Disc {
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();  ///< centre in robot base [m]
  Eigen::Vector3d normal_B = Eigen::Vector3d::UnitZ();
  double diameter_m = 0.007;
};

/// Where the healthy forearm and its discs are, as a function of the movement's own time ("phase").
class ArmMotion {
 public:
  virtual ~ArmMotion() = default;

  [[nodiscard]] virtual int discCount() const = 0;
  /// Fills `discs` (discCount() of them) at `phase_s` >= 0 of the movement. Any thread.
  virtual void discsAt(double phase_s, std::span<Disc> discs) const = 0;
  /// Elbow and wrist in robot base, for drawing.
  struct Forearm {
    Eigen::Vector3d elbow_B = Eigen::Vector3d::Zero();
    Eigen::Vector3d wrist_B = Eigen::Vector3d::Zero();
  };
  [[nodiscard]] virtual Forearm forearmAt(double phase_s) const = 0;
};

}  // namespace mirrorarm::simulation
