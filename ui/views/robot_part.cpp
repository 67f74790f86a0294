#include "ui/views/robot_part.h"

#include <algorithm>

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/lathe.h"
#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kDrumOver_m = 0.004;  // how far a drum stands out of the shell
constexpr double kDrumHeight = 0.75;   // of its radius

/// The thickest shell next to a joint: the drum must enclose it.
double shellRadiusAt(const robot::ArmDescription& arm, int joint) {
  double radius = 0.0;
  for (const auto& shape : arm.shapes)
    if (shape.link == joint || shape.link == joint + 1) radius = std::max(radius, shape.radius_m);
  return radius;
}

}  // namespace

RobotPart::RobotPart(const Workplace& workplace) {
  for (const auto& shape : workplace.arm.shapes) addCapsule(shape, Material::kShell);
  for (int joint = 0; joint < workplace.arm.jointCount(); ++joint) addJoint(workplace.arm, joint);
  for (const auto& shape : workplace.attached) addCapsule(shape, Material::kAttached);
}

void RobotPart::addCapsule(const robot::Capsule& capsule, Material material) {
  const double length = (capsule.b - capsule.a).norm();
  const bool ball = length < 1e-6;
  const RigidTransform X_LP =
      ball ? makeTransform(Eigen::Quaterniond::Identity(), capsule.a) : frameAlong(capsule.a, capsule.b);
  pieces_.push_back(
      {material, capsule.link, X_LP, makeSolid(lathe(capsuleOutline(length, capsule.radius_m)))});
}

void RobotPart::addJoint(const robot::ArmDescription& arm, int joint) {
  const double radius = shellRadiusAt(arm, joint) + kDrumOver_m;
  const auto& axis = arm.joints[static_cast<std::size_t>(joint)].axis;
  const RigidTransform X_LP = frameAlong(Eigen::Vector3d::Zero(), axis);
  pieces_.push_back({Material::kJoint, joint + 1, X_LP,
                     makeSolid(lathe(drumOutline(kDrumHeight * radius, radius, 0.012)))});
}

void RobotPart::addTo(vtkRenderer& renderer) {
  for (const auto& piece : pieces_) renderer.AddActor(piece.actor);
}

void RobotPart::paint(const Theme& theme) {
  for (const auto& piece : pieces_) {
    const auto* name = piece.material == Material::kShell   ? "robot_shell"
                       : piece.material == Material::kJoint ? "robot_joint"
                                                            : "robot_attached";
    setColour(*piece.actor, theme.colour(QLatin1String(name)));
  }
}

void RobotPart::show(const SceneMoment& moment) {
  for (const auto& piece : pieces_)
    setPose(*piece.actor, moment.X_BL[static_cast<std::size_t>(piece.link)] * piece.X_LP);
}

}  // namespace mirrorarm::ui
