#include "ui/views/table_part.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

// In tenths of a metre about the robot's foot, x towards the patient.
constexpr int kBack = -3, kFront = 11, kSide = 7;
constexpr double kCell_m = 0.1;
constexpr double kThickness_m = 0.03;

vtkSmartPointer<vtkPolyData> gridLines() {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> lines;
  const auto add = [&](double x0, double y0, double x1, double y1) {
    const vtkIdType from = points->InsertNextPoint(x0 * kCell_m, y0 * kCell_m, 0.001);
    lines->InsertNextCell({from, points->InsertNextPoint(x1 * kCell_m, y1 * kCell_m, 0.001)});
  };
  for (int x = kBack; x <= kFront; ++x) add(x, -kSide, x, kSide);
  for (int y = -kSide; y <= kSide; ++y) add(kBack, y, kFront, y);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> plate() {
  const vtkNew<vtkCubeSource> box;
  box->SetBounds(kBack * kCell_m, kFront * kCell_m, -kSide * kCell_m, kSide * kCell_m, -kThickness_m, 0.0);
  box->Update();
  return box->GetOutput();
}

}  // namespace

TablePart::TablePart() : top_(makeSolid(plate())), grid_(makeFlat(gridLines(), 1.0)) {
  top_->GetProperty()->SetSpecular(0.0);
  grid_->GetProperty()->SetOpacity(0.5);
}

void TablePart::addTo(vtkRenderer& renderer) {
  renderer.AddActor(top_);
  renderer.AddActor(grid_);
}

void TablePart::paint(const Theme& theme) {
  setColour(*top_, theme.colour(QStringLiteral("scene_table")));
  setColour(*grid_, theme.colour(QStringLiteral("scene_grid")));
}

}  // namespace mirrorarm::ui
