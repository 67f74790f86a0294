#include "ui/views/marker_part.h"

#include <vtkActor.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kMeasuredRadius_m = 0.0045;
constexpr double kTaughtRadius_m = 0.0075;

}  // namespace

MarkerPart::Cloud MarkerPart::makeCloud(double radius_m) {
  const vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius_m);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(12);
  Cloud cloud{vtkSmartPointer<vtkPoints>::New(), vtkSmartPointer<vtkActor>::New()};
  const vtkNew<vtkPolyData> places;
  places->SetPoints(cloud.points);
  const vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(ball->GetOutputPort());
  mapper->ScalarVisibilityOff();
  cloud.actor->SetMapper(mapper);
  return cloud;
}

MarkerPart::MarkerPart() : measured_(makeCloud(kMeasuredRadius_m)), taught_(makeCloud(kTaughtRadius_m)) {
  measured_.actor->GetProperty()->SetAmbient(0.7);
  measured_.actor->GetProperty()->SetDiffuse(0.4);
  taught_.actor->GetProperty()->SetOpacity(0.45);
}

void MarkerPart::addTo(vtkRenderer& renderer) {
  renderer.AddActor(measured_.actor);
  renderer.AddActor(taught_.actor);
}

void MarkerPart::paint(const Theme& theme) {
  setColour(*measured_.actor, theme.colour(QStringLiteral("marker_measured")));
  setColour(*taught_.actor, theme.colour(QStringLiteral("marker_taught")));
}

void MarkerPart::place(const Cloud& cloud, const std::vector<Eigen::Vector3d>& points_B) {
  cloud.points->SetNumberOfPoints(static_cast<vtkIdType>(points_B.size()));
  for (std::size_t i = 0; i < points_B.size(); ++i)
    cloud.points->SetPoint(static_cast<vtkIdType>(i), points_B[i].data());
  cloud.points->Modified();
  cloud.actor->SetVisibility(!points_B.empty());
}

void MarkerPart::show(const SceneMoment& moment) {
  const auto* frame = moment.snapshot.frame.get();
  points_B_.clear();
  if (frame != nullptr)
    for (const auto& point : frame->observation.points) points_B_.push_back(moment.X_BC * point.p_C);
  place(measured_, points_B_);
  points_B_.clear();
  if (frame != nullptr && frame->target && moment.X_BT)
    for (const auto& marker_T : frame->target->markers_T) points_B_.push_back(*moment.X_BT * marker_T);
  place(taught_, points_B_);
}

}  // namespace mirrorarm::ui
