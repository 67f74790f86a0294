#pragma once

#include <array>
#include <optional>

#include "core/robot/joints.h"
#include "core/robot/srs_arm.h"

namespace mirrorarm::robot {

inline constexpr int kSrsBranches = 8;

/// All postures of an S-R-S arm that bring the flange to one pose, in closed form. The elbow can turn about
/// the line from shoulder to wrist: its place on that circle is the arm angle [rad], 0 where the elbow points
/// up while the arm reaches ahead. At one arm angle eight branches b differ by the signs of the bending
/// joints: bit 0 of b turns joint 2 over, bit 1 joint 4, bit 2 joint 6. Joint limits are not looked at. Never
/// on the heap. Source: Shimizu et al., T-RO 24 (2008); Faria et al., Mech. Mach. Theory 121 (2018). The arm
/// angle is the stereographic one of Elias and Wen (arXiv 2307.13122): it is singular only where the wrist is
/// right behind the shoulder, at its height, where nobody sits.
class SrsPostures {
 public:
  /// Nothing when the wrist is out of reach.
  [[nodiscard]] static std::optional<SrsPostures> at(const SrsArm& arm, const RigidTransform& X_BF);

  /// Joints within -pi..pi. Where a shoulder or wrist is stretched out, joint 1 or 5 is 0.
  [[nodiscard]] Joints posture(double arm_angle, int branch) const;
  [[nodiscard]] std::array<Joints, kSrsBranches> branches(double arm_angle) const;
  /// d(joints)/d(arm angle) in a posture of this pose.
  [[nodiscard]] Joints rates(const Joints& q) const;

  /// A rotation R(psi) = constant + cosine cos(psi) + sine sin(psi) that the arm angle turns.
  struct Turning {
    Eigen::Matrix3d constant, cosine, sine;
    [[nodiscard]] Eigen::Matrix3d at(double cos_psi, double sin_psi) const {
      return constant + cos_psi * cosine + sin_psi * sine;
    }
  };
  /// The upper arm in U (joints 1 to 3) and the hand in the forearm (joints 5 to 7) of branch 0.
  [[nodiscard]] const Turning& shoulder() const { return shoulder_; }
  [[nodiscard]] const Turning& wrist() const { return wrist_; }

 private:
  explicit SrsPostures(const SrsArm& arm) : sign_(arm.sign) {}
  [[nodiscard]] Joints firstBranch(double arm_angle) const;
  [[nodiscard]] Joints turnedOver(const Joints& canonical, int branch) const;

  std::array<double, kSrsJoints> sign_;
  double elbow_ = 0.0;                                         // bend of joint 4, 0..pi
  Eigen::Vector3d towards_wrist_U = Eigen::Vector3d::UnitZ();  // axis of the arm angle
  Eigen::Vector3d turn_4_ = Eigen::Vector3d::UnitZ();          // by which the hand turns back, in the forearm
  Turning shoulder_, wrist_;
};

/// Where a posture's wrist is, and its arm angle.
struct SrsWrist {
  RigidTransform X_UW = RigidTransform::Identity();
  double arm_angle = 0.0;  ///< -pi..pi
};
[[nodiscard]] SrsWrist srsWrist(const SrsArm& arm, const Joints& q);

}  // namespace mirrorarm::robot
