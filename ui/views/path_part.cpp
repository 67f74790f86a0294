#include "ui/views/path_part.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr int kSamplesAhead = 40;
constexpr std::size_t kTrailPoints = 400;
constexpr double kTrailStep_m = 0.002;

}  // namespace

PathPart::Line PathPart::makeLine(double width_px) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtkSmartPointer<vtkPoints>::New());
  data->SetLines(vtkSmartPointer<vtkCellArray>::New());
  return {data, makeFlat(data, width_px)};
}

PathPart::PathPart(const Workplace& workplace)
    : joint_count_(workplace.arm.jointCount()),
      X_FE_(workplace.X_FE),
      kinematics_(workplace.arm),
      done_(makeLine(1.5)),
      ahead_(makeLine(4.0)) {
  done_.actor->GetProperty()->SetOpacity(0.6);
}

void PathPart::addTo(vtkRenderer& renderer) {
  renderer.AddActor(done_.actor);
  renderer.AddActor(ahead_.actor);
}

void PathPart::paint(const Theme& theme) {
  for (const auto* line : {&done_, &ahead_}) setColour(*line->actor, theme.colour(QStringLiteral("path")));
}

void PathPart::draw(const Line& line, const std::vector<Eigen::Vector3d>& points_B) {
  const auto count = static_cast<vtkIdType>(points_B.size());
  vtkPoints* points = line.data->GetPoints();
  points->SetNumberOfPoints(count);
  line.data->GetLines()->Reset();
  line.data->GetLines()->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    points->SetPoint(i, points_B[static_cast<std::size_t>(i)].data());
    line.data->GetLines()->InsertCellPoint(i);
  }
  points->Modified();
  line.data->GetLines()->Modified();
  line.actor->SetVisibility(count > 1);
}

void PathPart::remember(const Eigen::Vector3d& p_BE, therapy::Phase phase) {
  if (phase == therapy::Phase::kTaught) trail_B_.clear();
  if (phase != therapy::Phase::kTraining) return;
  if (!trail_B_.empty() && (trail_B_.back() - p_BE).norm() < kTrailStep_m) return;
  if (trail_B_.size() == kTrailPoints) trail_B_.erase(trail_B_.begin());
  trail_B_.push_back(p_BE);
}

void PathPart::lookAhead(const station::ControlState& control) {
  ahead_B_.clear();
  const auto& trajectory = control.trajectory;
  if (!trajectory.valid() || control.servo.at_rest || trajectory.end() <= control.time) return;
  const auto step = (trajectory.end() - control.time) / kSamplesAhead;
  for (int i = 0; i <= kSamplesAhead; ++i) {
    const auto state = trajectory.at(control.time + i * step);
    if (state.q_rad.size() != joint_count_) return;
    ahead_B_.push_back((kinematics_.flange(state.q_rad) * X_FE_).translation());
  }
}

void PathPart::show(const SceneMoment& moment) {
  remember(moment.X_BE.translation(), moment.snapshot.control.phase);
  lookAhead(moment.snapshot.control);
  draw(done_, trail_B_);
  draw(ahead_, ahead_B_);
}

}  // namespace mirrorarm::ui
