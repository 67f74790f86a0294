#include "benchmarks/calibration/opencv_stereo.h"

#include <array>
#include <numbers>
#include <vector>

#include <opencv2/calib3d.hpp>

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;

struct CvViews {
  std::vector<std::vector<cv::Point3f>> board;
  std::array<std::vector<std::vector<cv::Point2f>>, 2> seen;
};

/// Views that show all points alone: OpenCV's fisheye code takes the first view's number for that of all.
CvViews cvViews(const Board& board, std::span<const BoardView> views) {
  const auto points = boardPoints(board);
  CvViews result;
  for (const auto& view : views) {
    if (seenByBoth(view).size() < points.size()) continue;
    std::vector<cv::Point3f> corners;
    std::array<std::vector<cv::Point2f>, 2> pixels;
    for (const auto& [left, right] : seenByBoth(view)) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(left.point)].cast<float>();
      corners.emplace_back(p.x(), p.y(), p.z());
      pixels[0].emplace_back(static_cast<float>(left.pixel.x()), static_cast<float>(left.pixel.y()));
      pixels[1].emplace_back(static_cast<float>(right.pixel.x()), static_cast<float>(right.pixel.y()));
    }
    result.board.push_back(std::move(corners));
    for (std::size_t k = 0; k < 2; ++k) result.seen[k].push_back(std::move(pixels[k]));
  }
  return result;
}

camera::CameraModel modelOf(const cv::Matx33d& K, const std::vector<double>& distortion, ImageSize size,
                            camera::LensModel model) {
  camera::Intrinsics lens;
  lens.model = model;
  lens.width_px = size.width_px;
  lens.height_px = size.height_px;
  lens.fx_px = K(0, 0);
  lens.fy_px = K(1, 1);
  lens.cx_px = K(0, 2);
  lens.cy_px = K(1, 2);
  const std::size_t terms = model == camera::LensModel::kBrownConrady ? 2 : 4;
  for (std::size_t i = 0; i < terms; ++i) lens.distortion[i] = distortion[i];
  return camera::CameraModel(lens);
}

RigidTransform transformOf(const cv::Matx33d& R, const cv::Vec3d& t) {
  Eigen::Matrix3d rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation(i, j) = R(i, j);
  return makeTransform(rotation, {t[0], t[1], t[2]});
}

constexpr int kRadialOnly = cv::CALIB_ZERO_TANGENT_DIST | cv::CALIB_FIX_K3;
const cv::TermCriteria kThorough{cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-12};

double solvePinhole(const CvViews& views, cv::Size size, std::array<cv::Matx33d, 2>& K,
                    std::array<std::vector<double>, 2>& distortion, cv::Matx33d& R, cv::Vec3d& t) {
  for (std::size_t k = 0; k < 2; ++k)
    cv::calibrateCamera(views.board, views.seen[k], size, K[k], distortion[k], cv::noArray(), cv::noArray(),
                        kRadialOnly, kThorough);
  return cv::stereoCalibrate(views.board, views.seen[0], views.seen[1], K[0], distortion[0], K[1],
                             distortion[1], size, R, t, cv::noArray(), cv::noArray(),
                             kRadialOnly | cv::CALIB_USE_INTRINSIC_GUESS, kThorough);
}

/// OpenCV's own start gives no numbers for this lens: it is told the data sheet's angle.
constexpr double kAngle_rad = 135.0 / 180.0 * std::numbers::pi;

double solveFisheye(const CvViews& views, cv::Size size, std::array<cv::Matx33d, 2>& K,
                    std::array<std::vector<double>, 2>& distortion, cv::Matx33d& R, cv::Vec3d& t) {
  const int flags = cv::fisheye::CALIB_FIX_SKEW | cv::fisheye::CALIB_USE_INTRINSIC_GUESS;
  const double f_px = size.width / kAngle_rad;
  std::array<cv::Mat, 2> pinhole, bend;
  for (std::size_t k = 0; k < 2; ++k) {
    pinhole[k] = cv::Mat(
        cv::Matx33d(f_px, 0.0, 0.5 * (size.width - 1), 0.0, f_px, 0.5 * (size.height - 1), 0.0, 0.0, 1.0));
    bend[k] = cv::Mat::zeros(4, 1, CV_64F);
    cv::fisheye::calibrate(views.board, views.seen[k], size, pinhole[k], bend[k], cv::noArray(),
                           cv::noArray(), flags | cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC, kThorough);
  }
  cv::Mat rotation, translation;
  const double rms_px =
      cv::fisheye::stereoCalibrate(views.board, views.seen[0], views.seen[1], pinhole[0], bend[0], pinhole[1],
                                   bend[1], size, rotation, translation, flags, kThorough);
  for (std::size_t k = 0; k < 2; ++k) {
    K[k] = cv::Matx33d(pinhole[k]);
    distortion[k] = bend[k].reshape(1, 4);
  }
  R = cv::Matx33d(rotation);
  t = cv::Vec3d(translation);
  return rms_px;
}

}  // namespace

std::optional<OpenCvStereo> solveByOpenCv(const Board& board, std::span<const BoardView> views,
                                          ImageSize size, camera::LensModel model) {
  const auto given = cvViews(board, views);
  std::array<cv::Matx33d, 2> K;
  std::array<std::vector<double>, 2> distortion;
  cv::Matx33d R;
  cv::Vec3d t;
  OpenCvStereo result;
  try {
    const auto solve = model == camera::LensModel::kBrownConrady ? solvePinhole : solveFisheye;
    result.rms_px = solve(given, {size.width_px, size.height_px}, K, distortion, R, t);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  result.rig.left = modelOf(K[0], distortion[0], size, model);
  result.rig.right = modelOf(K[1], distortion[1], size, model);
  result.rig.X_RC = transformOf(R, t);
  return result;
}

}  // namespace mirrorarm::benchmarks::calibration
