#include "ui/views/lathe.h"

#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

namespace mirrorarm::ui {
namespace {

constexpr int kSides = 36;
constexpr int kArcSteps = 8;

void addArc(std::vector<OutlinePoint>& outline, OutlinePoint centre, double radius, double from, double to) {
  for (int i = 0; i <= kArcSteps; ++i) {
    const double angle = from + (to - from) * i / kArcSteps;
    outline.push_back({centre.z + radius * std::sin(angle), centre.radius + radius * std::cos(angle)});
  }
}

vtkIdType cornerOf(std::size_t ring, int side) {
  return static_cast<vtkIdType>(ring) * kSides + side % kSides;
}

}  // namespace

vtkSmartPointer<vtkPolyData> lathe(std::span<const OutlinePoint> outline, double flatness) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> faces;
  for (const auto& [z, radius] : outline)
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2.0 * std::numbers::pi * side / kSides;
      points->InsertNextPoint(radius * std::cos(angle), flatness * radius * std::sin(angle), z);
    }
  for (std::size_t ring = 0; ring + 1 < outline.size(); ++ring)
    for (int side = 0; side < kSides; ++side)
      faces->InsertNextCell({cornerOf(ring, side), cornerOf(ring, side + 1), cornerOf(ring + 1, side + 1),
                             cornerOf(ring + 1, side)});
  const vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(faces);
  const vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(60.0);
  normals->Update();
  return normals->GetOutput();
}

std::vector<OutlinePoint> capsuleOutline(double length, double radius) {
  using std::numbers::pi;
  std::vector<OutlinePoint> outline;
  addArc(outline, {0.0, 0.0}, radius, -pi / 2, 0.0);
  addArc(outline, {length, 0.0}, radius, 0.0, pi / 2);
  return outline;
}

std::vector<OutlinePoint> drumOutline(double height, double radius, double edge) {
  using std::numbers::pi;
  std::vector<OutlinePoint> outline{{-height / 2, 0.0}};
  addArc(outline, {-height / 2 + edge, radius - edge}, edge, -pi / 2, 0.0);
  addArc(outline, {height / 2 - edge, radius - edge}, edge, 0.0, pi / 2);
  outline.push_back({height / 2, 0.0});
  return outline;
}

}  // namespace mirrorarm::ui
