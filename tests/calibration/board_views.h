#pragma once

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"
#include "core/vision/centre_correction.h"

namespace mirrorarm::calibration {

inline camera::CameraModel lens(camera::LensModel model, double fx_px, double cx_px) {
  camera::Intrinsics i;
  i.model = model;
  i.width_px = 1296;
  i.height_px = 964;
  i.fx_px = fx_px;
  i.fy_px = 1.002 * fx_px;
  i.cx_px = cx_px;
  i.cy_px = 478.3;
  if (model == camera::LensModel::kBrownConrady)
    i.distortion = {-0.21, 0.04, 0.0, 0.0, 0.0};
  else
    i.distortion = {0.03, -0.012, 0.004, -0.0006, 0.0};
  return camera::CameraModel(i);
}

/// A bar of 120 mm, slightly toed in: a narrow lens pair, or fisheyes of 135 degrees.
inline camera::StereoRig trueRig(camera::LensModel model) {
  camera::StereoRig rig;
  const double f_px = model == camera::LensModel::kBrownConrady ? 1050.0 : 550.0;
  rig.left = lens(model, f_px, 651.7);
  rig.right = lens(model, 1.005 * f_px, 643.1);
  rig.X_RC =
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.2, 1.0, -0.1).normalized())),
                    Eigen::Vector3d(-0.12, 0.001, 0.002));
  return rig;
}

/// Makes views of a board as a person would hold it: tilted up to 40 degrees, all over both images.
struct ViewMaker {
  camera::StereoRig rig;
  Board board{BoardKind::kChessboard, 9, 6, 0.025};
  double noise_px = 0.0;
  double disc_radius_m = 0.0;  ///< the points are discs, seen by the centres of their outlines; 0: corners
  double bow_m = 0.0;          ///< height of the real board's middle over its ends, along the rows
  double stretch = 0.0;        ///< of the real board's steps along the rows against those across
  bool tells_sigma = false;    ///< the sightings carry the noise as their standard deviation
  double reach = 0.6;          ///< how far the board goes aside, as a share of its distance
  std::mt19937 random{3};

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }

  RigidTransform boardPose() {
    const Eigen::Vector3d axis(between(-1, 1), between(-1, 1), between(-0.3, 0.3));
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(between(0.1, 0.7), axis.normalized()));
    const double z = between(0.28, 0.6);
    const Eigen::Vector3d middle(0.1, 0.0625, 0.0);
    return makeTransform(
        tilt, Eigen::Vector3d(z * between(-reach, reach) + 0.06, 0.7 * z * between(-reach, reach), z) -
                  tilt * middle);
  }

  /// The points where they really are.
  std::vector<Eigen::Vector3d> realPoints() const {
    auto points = boardPoints(board);
    const double length = board.spacing_m * (board.columns - 1);
    for (auto& p : points) {
      const double from_middle = 2.0 * p.x() / length - 1.0;
      p = {p.x() * (1.0 + 0.5 * stretch), p.y() * (1.0 - 0.5 * stretch),
           bow_m * (1.0 - from_middle * from_middle)};
    }
    return points;
  }

  /// What an image without noise shows of one point.
  std::optional<SeenPoint> imageOf(const camera::CameraModel& camera, const RigidTransform& X_KM,
                                   const Eigen::Vector3d& p_M) const {
    camera::CameraModel::ProjectJacobian by_point;
    const auto pixel = camera.project(X_KM * p_M, by_point);
    if (!pixel) return std::nullopt;
    SeenPoint seen;
    seen.pixel = *pixel;
    seen.sigma_px = tells_sigma ? noise_px : 0.0;
    if (disc_radius_m <= 0.0) return seen;
    const vision::FlatDisc disc{X_KM * p_M, -X_KM.linear().col(2), disc_radius_m};
    const Eigen::Matrix2d axes = disc_radius_m * by_point * X_KM.linear().leftCols<2>();
    seen.shape_px2 = axes * axes.transpose();
    seen.pixel += vision::centreBias(camera, disc).value();
    return seen;
  }

  bool see(const camera::CameraModel& camera, const RigidTransform& X_KM, Sighting& sighting) {
    std::normal_distribution<double> noise(0.0, 1.0);
    for (const auto& p_M : realPoints()) {
      auto seen = imageOf(camera, X_KM, p_M);
      if (!seen || !camera.sees(seen->pixel, 2.0)) return false;
      seen->point = static_cast<int>(sighting.size());
      seen->pixel += noise_px * Eigen::Vector2d(noise(random), noise(random));
      sighting.push_back(*seen);
    }
    return true;
  }

  BoardView view(const RigidTransform& X_CM, const std::string& name) {
    BoardView view{name, {}};
    if (!see(rig.left, X_CM, view.seen[0]) || !see(rig.right, rig.X_RC * X_CM, view.seen[1])) view.seen = {};
    return view;
  }

  std::vector<BoardView> views(std::size_t count) {
    std::vector<BoardView> made;
    while (made.size() < count) {
      auto next = view(boardPose(), "view" + std::to_string(made.size()));
      if (!next.seen[0].empty()) made.push_back(std::move(next));
    }
    return made;
  }
};

}  // namespace mirrorarm::calibration
