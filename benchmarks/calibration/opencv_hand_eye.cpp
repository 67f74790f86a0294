#include "benchmarks/calibration/opencv_hand_eye.h"

#include <vector>

#include <opencv2/calib3d.hpp>

namespace mirrorarm::benchmarks::calibration {
namespace {

constexpr std::array<cv::HandEyeCalibrationMethod, kOpenCvMethods> kMethods = {
    cv::CALIB_HAND_EYE_TSAI, cv::CALIB_HAND_EYE_PARK, cv::CALIB_HAND_EYE_HORAUD, cv::CALIB_HAND_EYE_ANDREFF,
    cv::CALIB_HAND_EYE_DANIILIDIS};

cv::Mat rotation(const RigidTransform& X) {
  cv::Matx33d R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = X(i, j);
  return cv::Mat(R);
}

cv::Mat translation(const RigidTransform& X) {
  return cv::Mat(cv::Vec3d(X.translation().x(), X.translation().y(), X.translation().z()));
}

}  // namespace

std::optional<RigidTransform> handEyeByOpenCv(std::size_t i,
                                              std::span<const mirrorarm::calibration::PosePair> pairs) {
  std::vector<cv::Mat> R_BF, t_BF, R_CM, t_CM;
  for (const auto& pair : pairs) {
    R_BF.push_back(rotation(pair.X_BF));
    t_BF.push_back(translation(pair.X_BF));
    R_CM.push_back(rotation(pair.X_CM));
    t_CM.push_back(translation(pair.X_CM));
  }
  cv::Matx33d R;
  cv::Vec3d t;
  try {
    cv::calibrateHandEye(R_BF, t_BF, R_CM, t_CM, R, t, kMethods[i]);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  RigidTransform X_FC = RigidTransform::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) X_FC(row, column) = R(row, column);
    X_FC(row, 3) = t[row];
  }
  return X_FC;
}

}  // namespace mirrorarm::benchmarks::calibration
