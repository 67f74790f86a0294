#include "ui/views/robot_part.h"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/lathe.h"
#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kRingOver_m = 0.004;  // how far a ring stands out of the shell
constexpr double kRingHeight = 0.75;   // of its radius
constexpr double kCapOver_m = 0.010;   // how far the caps of a hinge stand out at both sides
constexpr double kCapRadius = 0.78;    // of the shell's
constexpr double kEdge_m = 0.008;

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

// A joint that twists the arm shows as a ring around it, a hinge as caps on both its sides.
void RobotPart::addJoint(const robot::ArmDescription& arm, int joint) {
  const double shell = shellRadiusAt(arm, joint);
  const auto& description = arm.joints[static_cast<std::size_t>(joint)];
  const bool hinge = std::abs(description.axis.z()) < 0.5;  // links lie along z of their frames
  const auto outline = hinge ? drumOutline(2.0 * (shell + kCapOver_m), kCapRadius * shell, kEdge_m)
                             : drumOutline(kRingHeight * shell, shell + kRingOver_m, kEdge_m);
  const RigidTransform X_LP = frameAlong(Eigen::Vector3d::Zero(), description.axis);
  pieces_.push_back({Material::kJoint, joint + 1, X_LP, makeSolid(lathe(outline))});
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
