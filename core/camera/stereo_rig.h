#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/camera/camera_model.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::camera {

/// Standard deviations of one camera's numbers, in the order and units of Intrinsics; 0 when unknown.
struct LensSigma {
  double fx_px = 0.0, fy_px = 0.0, cx_px = 0.0, cy_px = 0.0;
  std::array<double, 5> distortion{};
};

/// Where a calibration came from; every line is optional, numbers are 0 when unknown.
struct CalibrationNote {
  std::string date;         ///< ISO 8601
  std::string method;       ///< what solved it
  std::string software;     ///< name and version
  std::string board;        ///< as the command line writes it
  std::string left_serial;  ///< of a single camera too
  std::string right_serial;
  std::vector<std::string> images;    ///< behind the solution, by the left image's name
  std::vector<std::string> held_out;  ///< kept out of it to measure on
  std::vector<std::string> outliers;  ///< left out of it
  double rms_px = 0.0;                ///< reprojection error of the views used

  std::string hold_out_method;  ///< how the next ones, of views not used, were got
  double hold_out_epipolar_px = 0.0;
  double hold_out_px = 0.0;          ///< reprojection
  double square_mean_percent = 0.0;  ///< triangulated lengths on the board against the true ones
  double square_std_percent = 0.0;
  double depth_rms_m = 0.0;

  std::array<LensSigma, 2> lens_sigma{};
  Eigen::Matrix<double, 6, 1> bar_sigma = Eigen::Matrix<double, 6, 1>::Zero();  ///< turn [rad], shift [m]
};

/// Two cameras on one bar. Frame C is the left camera, R the right one.
struct StereoRig {
  CameraModel left;
  CameraModel right;
  RigidTransform X_RC = RigidTransform::Identity();  ///< p_R = X_RC * p_C
  CalibrationNote calibration;
};

}  // namespace mirrorarm::camera
