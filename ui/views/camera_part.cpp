#include "ui/views/camera_part.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/lathe.h"
#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kSeen_m = 0.24;        // how deep the pyramid is drawn
constexpr double kWidestTangent = 1.2;  // a fisheye's corners are drawn no further out

/// The image corners on the plane z = kSeen_m of the camera.
std::array<Eigen::Vector3d, 4> cornersOf(const camera::CameraModel& camera) {
  const double right = camera.intrinsics().width_px - 1.0;
  const double bottom = camera.intrinsics().height_px - 1.0;
  const std::array<Eigen::Vector2d, 4> pixels{
      Eigen::Vector2d(0, 0), {right, 0}, {right, bottom}, {0, bottom}};
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Eigen::Vector2d ray = camera.unproject(pixels[i]).value_or(
        Eigen::Vector2d(pixels[i].x() > 0 ? kWidestTangent : -kWidestTangent,
                        pixels[i].y() > 0 ? kWidestTangent : -kWidestTangent));
    if (ray.norm() > kWidestTangent) ray *= kWidestTangent / ray.norm();
    corners[i] = Eigen::Vector3d(ray.x(), ray.y(), 1.0) * kSeen_m;
  }
  return corners;
}

vtkSmartPointer<vtkPoints> apexAndCorners(const camera::CameraModel& camera) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->InsertNextPoint(0, 0, 0);
  for (const auto& corner : cornersOf(camera)) points->InsertNextPoint(corner.data());
  return points;
}

vtkSmartPointer<vtkPolyData> edgesOf(const camera::CameraModel& camera) {
  const vtkNew<vtkCellArray> lines;
  for (vtkIdType corner = 1; corner <= 4; ++corner) {
    lines->InsertNextCell({0, corner});
    lines->InsertNextCell({corner, corner % 4 + 1});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(apexAndCorners(camera));
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> sidesOf(const camera::CameraModel& camera) {
  const vtkNew<vtkCellArray> faces;
  for (vtkIdType corner = 1; corner <= 4; ++corner) faces->InsertNextCell({0, corner, corner % 4 + 1});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(apexAndCorners(camera));
  data->SetPolys(faces);
  return data;
}

}  // namespace

CameraPart::CameraPart(const camera::StereoRig& rig) {
  const auto make = [](const RigidTransform& X_CK, const camera::CameraModel& camera) {
    const std::vector<OutlinePoint> housing{{-0.05, 0.0},    {-0.05, 0.017}, {-0.012, 0.017},
                                            {-0.012, 0.013}, {0.0, 0.013},   {0.0, 0.0}};
    return Eye{X_CK, makeSolid(lathe(housing)), makeFlat(edgesOf(camera), 1.2),
               makeFlat(sidesOf(camera), 1.0)};
  };
  eyes_ = {make(RigidTransform::Identity(), rig.left), make(rig.X_RC.inverse(), rig.right)};
  for (const auto& eye : eyes_) {
    eye.edges->GetProperty()->SetOpacity(0.55);
    eye.sides->GetProperty()->SetOpacity(0.06);
  }
}

void CameraPart::addTo(vtkRenderer& renderer) {
  for (const auto& eye : eyes_)
    for (const auto& actor : {eye.body, eye.edges, eye.sides}) renderer.AddActor(actor);
}

void CameraPart::paint(const Theme& theme) {
  for (const auto& eye : eyes_) {
    setColour(*eye.body, theme.colour(QStringLiteral("camera_body")));
    setColour(*eye.edges, theme.colour(QStringLiteral("frustum")));
    setColour(*eye.sides, theme.colour(QStringLiteral("frustum")));
  }
}

void CameraPart::show(const SceneMoment& moment) {
  for (const auto& eye : eyes_)
    for (const auto& actor : {eye.body, eye.edges, eye.sides}) setPose(*actor, moment.X_BC * eye.X_CK);
}

}  // namespace mirrorarm::ui
