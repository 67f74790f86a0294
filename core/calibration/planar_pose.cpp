#include "core/calibration/planar_pose.h"

#include <opencv2/calib3d.hpp>

#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestPoints = 4;

struct Pairs {
  std::vector<cv::Point3d> board;
  std::vector<cv::Point2d> straight;  ///< on the plane z = 1
};

Pairs straightened(const camera::CameraModel& camera, std::span<const Eigen::Vector3d> board,
                   const Sighting& sighting) {
  Pairs pairs;
  for (const auto& seen : sighting) {
    const auto direction = camera.unproject(seen.pixel);
    if (!direction) continue;
    const Eigen::Vector3d& p_M = board[static_cast<std::size_t>(seen.point)];
    pairs.board.emplace_back(p_M.x(), p_M.y(), p_M.z());
    pairs.straight.emplace_back(direction->x(), direction->y());
  }
  return pairs;
}

RigidTransform fromRodrigues(const cv::Mat& turn, const cv::Mat& shift) {
  const auto vector = [](const cv::Mat& m) {
    return Eigen::Vector3d(m.at<double>(0), m.at<double>(1), m.at<double>(2));
  };
  return makeTransform(turnBy(vector(turn)), vector(shift));
}

}  // namespace

std::vector<RigidTransform> planarPoses(const camera::CameraModel& camera,
                                        std::span<const Eigen::Vector3d> board, const Sighting& sighting) {
  std::vector<RigidTransform> poses;
  const auto pairs = straightened(camera, board, sighting);
  if (pairs.board.size() < kFewestPoints) return poses;
  std::vector<cv::Mat> turns, shifts;
  try {
    cv::solvePnPGeneric(pairs.board, pairs.straight, cv::Matx33d::eye(), cv::noArray(), turns, shifts, false,
                        cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return poses;
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto X_CM = fromRodrigues(turns[i], shifts[i]);
    if (isRigid(X_CM)) poses.push_back(X_CM);
  }
  return poses;
}

}  // namespace mirrorarm::calibration
