#pragma once

#include <string>

#include "core/camera/camera_model.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::camera {

/// Where a calibration came from; every line is optional.
struct CalibrationNote {
  std::string date;                   ///< ISO 8601
  std::string method;                 ///< what solved it
  double rms_px = 0.0;                ///< reprojection error of the views used; 0 when unknown
  double hold_out_epipolar_px = 0.0;  ///< on views not used; 0 when unknown
  std::string left_serial;
  std::string right_serial;
};

/// Two cameras on one bar. Frame C is the left camera, R the right one.
struct StereoRig {
  CameraModel left;
  CameraModel right;
  RigidTransform X_RC = RigidTransform::Identity();  ///< p_R = X_RC * p_C
  CalibrationNote calibration;
};

}  // namespace mirrorarm::camera
