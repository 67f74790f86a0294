#pragma once

#include <numbers>
#include <random>
#include <vector>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// A robot with a camera, its truth known: it makes the stations that a calibration would capture.
struct StationMaker {
  RigidTransform X_FC = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(1.6, Eigen::Vector3d::UnitZ())),
                                      Eigen::Vector3d(0.058, -0.034, 0.042));
  RigidTransform X_BM = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitX())),
                                      Eigen::Vector3d(0.55, 0.05, 0.02));
  double smallest_turn_deg = 17.0;
  double largest_turn_deg = 35.0;
  double noise_m = 0.0;
  double noise_deg = 0.0;
  std::mt19937 random{11};

  Eigen::Vector3d normal3() {
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random)};
  }

  RigidTransform noise() {
    const Eigen::Vector3d turn = normal3() * noise_deg * std::numbers::pi / 180.0;
    return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized())),
                         noise_m * normal3());
  }

  /// A station turned about `axis` from the middle one; camera in the hand.
  PosePair station(const Eigen::Vector3d& axis) {
    std::uniform_real_distribution<double> turn_deg(smallest_turn_deg, largest_turn_deg);
    const Eigen::AngleAxisd turn(turn_deg(random) * std::numbers::pi / 180.0, axis.normalized());
    const RigidTransform middle =
        makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitY())),
                      Eigen::Vector3d(0.5, 0.0, 0.45));
    PosePair pair;
    pair.X_BF = middle * makeTransform(Eigen::Quaterniond(turn), 0.08 * normal3());
    pair.X_CM = noise() * X_FC.inverse() * pair.X_BF.inverse() * X_BM;
    return pair;
  }

  std::vector<PosePair> stations(int count) {
    std::vector<PosePair> made;
    for (int i = 0; i < count; ++i) made.push_back(station(normal3()));
    return made;
  }

  std::vector<PosePair> stationsAboutOneAxis(int count) {
    std::vector<PosePair> made;
    for (int i = 0; i < count; ++i)
      made.push_back(station(i % 2 ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(0, 0, -1)));
    return made;
  }

  /// The same with the camera beside the robot: the truth X_FC is then X_BC.
  std::vector<PosePair> stationsToHand(int count) {
    auto made = stations(count);
    for (auto& pair : made) pair.X_BF = pair.X_BF.inverse();
    return made;
  }
};

}  // namespace mirrorarm::calibration
