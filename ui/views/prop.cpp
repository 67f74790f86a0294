#include "ui/views/prop.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace mirrorarm::ui {
namespace {

vtkSmartPointer<vtkActor> makeActor(const vtkSmartPointer<vtkPolyData>& data) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  const vtkNew<vtkMatrix4x4> pose;
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetUserMatrix(pose);
  return actor;
}

}  // namespace

vtkSmartPointer<vtkActor> makeSolid(const vtkSmartPointer<vtkPolyData>& surface) {
  auto actor = makeActor(surface);
  vtkProperty* look = actor->GetProperty();
  look->SetInterpolationToPhong();
  look->SetAmbient(0.18);
  look->SetDiffuse(0.82);
  look->SetSpecular(0.22);
  look->SetSpecularPower(28.0);
  return actor;
}

vtkSmartPointer<vtkActor> makeFlat(const vtkSmartPointer<vtkPolyData>& drawing, double width_px) {
  auto actor = makeActor(drawing);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(width_px));
  return actor;
}

void setPose(vtkProp3D& prop, const RigidTransform& X_BP) {
  vtkMatrix4x4* matrix = prop.GetUserMatrix();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, X_BP.matrix()(row, column));
}

void setColour(vtkActor& actor, const QColor& colour) {
  actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

RigidTransform frameAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to - from);
  return makeTransform(turn, from);
}

}  // namespace mirrorarm::ui
