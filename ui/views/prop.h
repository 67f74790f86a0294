#pragma once

#include <Eigen/Core>
#include <QColor>
#include <vtkSmartPointer.h>

#include "core/geometry/rigid_transform.h"

class vtkActor;
class vtkPolyData;
class vtkProp3D;

namespace mirrorarm::ui {

/// An actor of `surface` with the soft shine that solid things of the scene share.
[[nodiscard]] vtkSmartPointer<vtkActor> makeSolid(const vtkSmartPointer<vtkPolyData>& surface);
/// An actor of lines or signs, drawn in their plain colour without light.
[[nodiscard]] vtkSmartPointer<vtkActor> makeFlat(const vtkSmartPointer<vtkPolyData>& drawing,
                                                 double width_px);

void setPose(vtkProp3D& prop, const RigidTransform& X_BP);
void setColour(vtkActor& actor, const QColor& colour);

/// The frame with its origin at `from` and its z axis towards `to`.
[[nodiscard]] RigidTransform frameAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace mirrorarm::ui
