#include "core/camera/stereo_view.h"

namespace mirrorarm::camera {

bool bothCamerasSee(const StereoRig& rig, const Eigen::Vector3d& p_C, double margin_px) {
  const auto sees = [margin_px](const CameraModel& camera, const Eigen::Vector3d& p) {
    const auto pixel = camera.project(p);
    return pixel && camera.sees(*pixel, margin_px);
  };
  return sees(rig.left, p_C) && sees(rig.right, rig.X_RC * p_C);
}

}  // namespace mirrorarm::camera
