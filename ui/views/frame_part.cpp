#include "ui/views/frame_part.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "ui/views/lathe.h"
#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kThickness_m = 0.0022;
const std::array<Eigen::Vector3d, 3> kAxes{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                           Eigen::Vector3d::UnitZ()};
const std::array<const char*, 3> kAxisColours{"bad", "good", "healthy"};

vtkSmartPointer<vtkActor> makeGoal() {
  const vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.022);
  ball->SetThetaResolution(28);
  ball->SetPhiResolution(20);
  ball->Update();
  auto actor = makeSolid(ball->GetOutput());
  actor->GetProperty()->SetOpacity(0.4);
  return actor;
}

}  // namespace

FramePart::Triad FramePart::makeTriad(double length_m) {
  const double tip = 0.25 * length_m;
  const std::vector<OutlinePoint> arrow{{0.0, 0.0},
                                        {0.0, kThickness_m},
                                        {length_m - tip, kThickness_m},
                                        {length_m - tip, 2.6 * kThickness_m},
                                        {length_m, 0.0}};
  Triad triad;
  for (auto& axis : triad) axis = makeSolid(lathe(arrow));
  return triad;
}

FramePart::FramePart() : target_(makeTriad(0.09)), sling_(makeTriad(0.06)), goal_(makeGoal()) {}

void FramePart::addTo(vtkRenderer& renderer) {
  for (const auto* triad : {&target_, &sling_})
    for (const auto& axis : *triad) renderer.AddActor(axis);
  renderer.AddActor(goal_);
}

void FramePart::paint(const Theme& theme) {
  for (const auto* triad : {&target_, &sling_})
    for (std::size_t i = 0; i < triad->size(); ++i)
      setColour(*(*triad)[i], theme.colour(QLatin1String(kAxisColours[i])));
  setColour(*goal_, theme.colour(QStringLiteral("goal")));
}

void FramePart::place(const Triad& triad, const RigidTransform& X_BP) {
  for (std::size_t i = 0; i < triad.size(); ++i)
    setPose(*triad[i], X_BP * frameAlong(Eigen::Vector3d::Zero(), kAxes[i]));
}

void FramePart::show(const SceneMoment& moment) {
  for (const auto& axis : target_) axis->SetVisibility(moment.X_BT.has_value());
  if (moment.X_BT) place(target_, *moment.X_BT);
  place(sling_, moment.X_BE);
  goal_->SetVisibility(moment.X_BE_goal.has_value());
  if (moment.X_BE_goal) setPose(*goal_, *moment.X_BE_goal);
}

}  // namespace mirrorarm::ui
