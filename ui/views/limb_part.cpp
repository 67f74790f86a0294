#include "ui/views/limb_part.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/views/forearm_fit.h"
#include "ui/views/lathe.h"
#include "ui/views/prop.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

// Hand, wrist (at z = 0), forearm and elbow of an adult, as an outline about the bone.
const std::vector<OutlinePoint> kLimb{{-0.170, 0.000}, {-0.168, 0.008}, {-0.160, 0.015}, {-0.140, 0.024},
                                      {-0.110, 0.033}, {-0.085, 0.037}, {-0.055, 0.035}, {-0.030, 0.030},
                                      {-0.010, 0.027}, {0.010, 0.0265}, {0.050, 0.030},  {0.090, 0.035},
                                      {0.130, 0.040},  {0.170, 0.043},  {0.210, 0.0435}, {0.245, 0.041},
                                      {0.265, 0.036},  {0.280, 0.026},  {0.287, 0.014},  {0.290, 0.000}};
constexpr double kFlatness = 0.85;
constexpr double kMiddleFromWrist_m = 0.125;
constexpr double kSleeveMargin_m = 0.015;
constexpr double kSleeveEdge_m = 0.006;

vtkSmartPointer<vtkActor> makeLimb() {
  auto limb = makeSolid(lathe(kLimb, kFlatness));
  limb->GetProperty()->SetSpecular(0.06);
  return limb;
}

vtkSmartPointer<vtkPolyData> sleeveOf(const ForearmFit& fit) {
  return lathe(drumOutline(2.0 * (fit.half_length_m + kSleeveMargin_m), fit.radius_m, kSleeveEdge_m));
}

}  // namespace

LimbPart::LimbPart(const Workplace& workplace)
    : impaired_elbow_B_(workplace.impaired_elbow_B),
      healthy_(makeLimb()),
      sleeve_(makeSolid(vtkSmartPointer<vtkPolyData>::New())),
      impaired_(makeLimb()) {
  sleeve_->GetProperty()->SetSpecular(0.0);
}

void LimbPart::addTo(vtkRenderer& renderer) {
  for (const auto& actor : {healthy_, sleeve_, impaired_}) renderer.AddActor(actor);
}

void LimbPart::paint(const Theme& theme) {
  setColour(*healthy_, theme.colour(QStringLiteral("limb_healthy")));
  setColour(*sleeve_, theme.colour(QStringLiteral("sleeve")));
  setColour(*impaired_, theme.colour(QStringLiteral("limb_impaired")));
}

// T was taught with the camera's axes, so that -z looked towards the cameras. The elbow is the end nearer to
// the patient (+x of B).
void LimbPart::fitTo(const tracking::Target& target, const RigidTransform& X_BT) {
  const ForearmFit fit = fitForearm(target.markers_T, -Eigen::Vector3d::UnitZ());
  X_TS_ = fit.X_TA;
  RigidTransform X_TA = fit.X_TA;
  const bool towards_patient = (X_BT.linear() * X_TA.linear().col(2)).x() > 0.0;
  if (!towards_patient) X_TA.rotate(Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitY()));
  X_TL_ = X_TA * Eigen::Translation3d(0.0, 0.0, -kMiddleFromWrist_m);
  static_cast<vtkPolyDataMapper*>(sleeve_->GetMapper())->SetInputData(sleeveOf(fit));
}

void LimbPart::show(const SceneMoment& moment) {
  const auto* frame = moment.snapshot.frame.get();
  const bool seen = frame != nullptr && frame->target && moment.X_BT;
  if (seen && frame->target != fitted_) {
    fitted_ = frame->target;
    fitTo(*fitted_, *moment.X_BT);
  }
  healthy_->SetVisibility(seen);
  sleeve_->SetVisibility(seen);
  if (seen) setPose(*healthy_, *moment.X_BT * X_TL_);
  if (seen) setPose(*sleeve_, *moment.X_BT * X_TS_);
  setPose(*impaired_, frameAlong(moment.X_BE.translation(), impaired_elbow_B_));
}

}  // namespace mirrorarm::ui
