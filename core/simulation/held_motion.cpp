#include "core/simulation/held_motion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "core/geometry/small_motion.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"

namespace mirrorarm::simulation {
namespace {

constexpr double kStep_s = 0.004;  // between two poses that are kept: the UR5's own cycle is twice as long

/// Newton's last steps: the joints that `kinematics` finds are good to 0.1 mm, which would move the plate in
/// steps.
robot::Joints refined(const robot::Kinematics& kinematics, const RigidTransform& X_UF, robot::Joints q) {
  constexpr int steps = 2;
  for (int i = 0; i < steps; ++i) {
    const RigidTransform X_now = kinematics.flange(q);
    Eigen::Matrix<double, 6, 1> way;
    way << X_UF.translation() - X_now.translation(),
        rotationVector(Eigen::Matrix3d(X_UF.linear() * X_now.linear().transpose()));
    q += Eigen::MatrixXd(kinematics.jacobian(q)).colPivHouseholderQr().solve(way);
  }
  return q;
}

}  // namespace

FromFile<std::unique_ptr<HeldMotion>> HeldMotion::make(const Scene& scene,
                                                       const std::filesystem::path& resources,
                                                       const Path& path, double duration_s) {
  const Scene::Target& target = scene.target;
  if (target.carried_by != Carrier::kUr5)
    return unexpected(FileError{scene.file, 0, "no UR5 holds the target"});
  const auto arm = robot::readUrdf(resources / "robots/ur5.urdf");
  if (!arm) return unexpected(arm.error());
  const robot::Kinematics kinematics(*arm);
  robot::Joints q = Eigen::Map<const Eigen::VectorXd>(target.posture_rad.data(),
                                                      static_cast<Eigen::Index>(target.posture_rad.size()));
  std::vector<RigidTransform> poses;
  const int steps = static_cast<int>(std::ceil(duration_s / kStep_s));
  for (int i = 0; i <= steps; ++i) {
    const RigidTransform X_BT = Eigen::Translation3d(path(i * kStep_s)) * target.X_WT;
    const RigidTransform X_UF = target.X_WU.inverse() * X_BT * target.X_FT.inverse();
    const auto next = kinematics.inverse(X_UF, q);
    if (!next) return unexpected(FileError{scene.file, 0, "target.ur5 does not reach all of the path"});
    q = refined(kinematics, X_UF, *next);
    poses.push_back(target.X_WU * kinematics.flange(q) * target.X_FT);
  }
  return std::unique_ptr<HeldMotion>(new HeldMotion(target.discs_T, target.X_FT.inverse(), std::move(poses)));
}

RigidTransform HeldMotion::poseAt(double phase_s) const {
  const double at = std::clamp(phase_s / kStep_s, 0.0, static_cast<double>(poses_.size() - 1));
  const auto before = static_cast<std::size_t>(at);
  const std::size_t after = std::min(before + 1, poses_.size() - 1);
  return interpolate(poses_[before], poses_[after], at - static_cast<double>(before));
}

void HeldMotion::discsAt(double phase_s, std::span<Disc> discs) const {
  const RigidTransform X_BT = poseAt(phase_s);
  for (std::size_t i = 0; i < discs.size(); ++i)
    discs[i] = {X_BT * discs_T_[i].p_B, X_BT.linear() * discs_T_[i].normal_B, discs_T_[i].diameter_m};
}

ArmMotion::Forearm HeldMotion::forearmAt(double phase_s) const {
  const RigidTransform X_BT = poseAt(phase_s);
  return {(X_BT * X_TF_).translation(), X_BT.translation()};
}

}  // namespace mirrorarm::simulation
