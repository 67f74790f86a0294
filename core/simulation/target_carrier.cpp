#include "core/simulation/target_carrier.h"

#include "core/geometry/rigid_fit.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/exercise_motion.h"

namespace mirrorarm::simulation {
namespace {

using Made = FromFile<std::unique_ptr<TargetCarrier>>;

std::vector<Disc> moved(const RigidTransform& X_WT, const std::vector<Disc>& discs_T) {
  std::vector<Disc> discs_W;
  for (const Disc& disc : discs_T)
    discs_W.push_back({X_WT * disc.p_B, X_WT.linear() * disc.normal_B, disc.diameter_m});
  return discs_W;
}

/// A table, or a forearm that moves by legs.
class RigidCarrier final : public TargetCarrier {
 public:
  explicit RigidCarrier(const Scene::Target& target)
      : discs_T_(target.discs_T), motion_(target.X_WT, target.legs) {}
  const std::vector<Disc>& discs_T() const override { return discs_T_; }
  Moment at(double time_s) override {
    const RigidTransform X_WT = motion_.poseAt(time_s);
    return {moved(X_WT, discs_T_), X_WT, std::nullopt};
  }

 private:
  std::vector<Disc> discs_T_;
  ExerciseMotion motion_;
};

std::vector<Eigen::Vector3d> centresOf(const std::vector<Disc>& discs) {
  std::vector<Eigen::Vector3d> centres;
  for (const Disc& disc : discs) centres.push_back(disc.p_B);
  return centres;
}

/// A recorded forearm. T stands at the markers' centroid, turned like the forearm's start pose.
class RecordedCarrier final : public TargetCarrier {
 public:
  RecordedCarrier(RecordedMotion motion, const Scene::Target& target)
      : motion_(std::move(motion)), diameter_m_(target.marker_diameter_m) {
    const auto start_W = discsAt(0.0);
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (const Disc& disc : start_W) centroid += disc.p_B / static_cast<double>(start_W.size());
    discs_T_ = moved(makeTransform(Eigen::Matrix3d(target.X_WT.linear()), centroid).inverse(), start_W);
  }
  const std::vector<Disc>& discs_T() const override { return discs_T_; }
  Moment at(double time_s) override {
    auto discs_W = discsAt(time_s);
    const RigidTransform X_WT = fitByKabsch(centresOf(discs_T_), centresOf(discs_W));
    return {std::move(discs_W), X_WT, std::nullopt};
  }

 private:
  [[nodiscard]] std::vector<Disc> discsAt(double time_s) const {
    std::vector<Disc> discs(static_cast<std::size_t>(motion_.discCount()));
    motion_.discsAt(time_s, discs);
    for (Disc& disc : discs) disc.diameter_m = diameter_m_;
    return discs;
  }

  RecordedMotion motion_;
  double diameter_m_ = 0.0;
  std::vector<Disc> discs_T_;
};

/// A UR5 whose flange follows the legs; the joints are the truth, so the pose comes from them.
class Ur5Carrier final : public TargetCarrier {
 public:
  Ur5Carrier(robot::Kinematics kinematics, const robot::Joints& start, const Scene::Target& target)
      : target_(target), path_(target.X_WT, target.legs), kinematics_(std::move(kinematics)), q_(start) {}

  static Made make(const Scene& scene, const std::filesystem::path& resources) {
    const auto arm = robot::readUrdf(resources / "robots/ur5.urdf");
    if (!arm) return unexpected(arm.error());
    const auto& target = scene.target;
    robot::Joints posture = Eigen::Map<const Eigen::VectorXd>(
        target.posture_rad.data(), static_cast<Eigen::Index>(target.posture_rad.size()));
    auto carrier = std::make_unique<Ur5Carrier>(robot::Kinematics(*arm), posture, target);
    if (carrier->kinematics_.jointCount() != posture.size())
      return unexpected(FileError{resources / "robots/ur5.urdf", 0, "has not six joints"});
    if (!carrier->moveTo(target.X_WT))
      return unexpected(FileError{scene.file, 0, "target.ur5 does not reach target.pose from posture_rad"});
    for (const auto& leg : target.legs)
      if (!carrier->reaches(Eigen::Translation3d(leg.displacement_m) * target.X_WT *
                            Eigen::AngleAxisd(-leg.forearm_turn_rad, Eigen::Vector3d::UnitX())))
        return unexpected(FileError{scene.file, 0, "target.ur5 does not reach the end of a leg"});
    return carrier;
  }

  const std::vector<Disc>& discs_T() const override { return target_.discs_T; }
  Moment at(double time_s) override {
    // Where the straight way between two reachable ends is not reachable, the arm stays and the truth says
    // so.
    static_cast<void>(moveTo(path_.poseAt(time_s)));
    const RigidTransform X_UF = kinematics_.flange(q_);
    const RigidTransform X_WT = target_.X_WU * X_UF * target_.X_FT;
    return {moved(X_WT, target_.discs_T), X_WT, RobotPose{q_, X_UF}};
  }

 private:
  [[nodiscard]] std::optional<robot::Joints> postureFor(const RigidTransform& X_WT) const {
    return kinematics_.inverse(target_.X_WU.inverse() * X_WT * target_.X_FT.inverse(), q_);
  }
  [[nodiscard]] bool reaches(const RigidTransform& X_WT) const { return postureFor(X_WT).has_value(); }
  [[nodiscard]] bool moveTo(const RigidTransform& X_WT) {
    const auto q = postureFor(X_WT);
    if (q) q_ = *q;
    return q.has_value();
  }

  Scene::Target target_;
  ExerciseMotion path_;
  robot::Kinematics kinematics_;
  robot::Joints q_;
};

}  // namespace

Made TargetCarrier::make(const Scene& scene, const RecordedMotion::CameraPositions& cameras_W,
                         const std::filesystem::path& resources) {
  if (scene.target.carried_by == Carrier::kUr5) return Ur5Carrier::make(scene, resources);
  if (scene.target.motion.empty()) return std::make_unique<RigidCarrier>(scene.target);
  auto motion = RecordedMotion::read(scene.target.motion, scene.target.X_WT, cameras_W);
  if (!motion) return unexpected(motion.error());
  return std::make_unique<RecordedCarrier>(std::move(*motion), scene.target);
}

}  // namespace mirrorarm::simulation
