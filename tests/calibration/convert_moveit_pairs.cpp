// Converts the pose samples of MoveIt's hand-eye tests into our pose pairs:
//   convert_moveit_pairs pose_samples.json pairs.csv
// The file is a list of [effector in world, object in sensor], each a 4x4 matrix by rows, metres. The world
// is the robot's base and the effector its flange; the sensor stands still, so solve with --eye to-hand.

#include <exception>
#include <fstream>
#include <iostream>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "core/calibration/pose_pairs.h"

namespace {

mirrorarm::RigidTransform pose(const nlohmann::json& rows) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix(row, column) = rows.at(row).at(column).get<double>();
  return mirrorarm::makeTransform(Eigen::Quaterniond(Eigen::Matrix3d(matrix.topLeftCorner<3, 3>())),
                                  matrix.topRightCorner<3, 1>());
}

std::vector<mirrorarm::calibration::PosePair> pairsOf(const char* file) {
  std::ifstream in(file);
  std::vector<mirrorarm::calibration::PosePair> pairs;
  for (const auto& sample : nlohmann::json::parse(in))
    pairs.push_back({pose(sample.at(0)), pose(sample.at(1))});
  return pairs;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: convert_moveit_pairs pose_samples.json pairs.csv");
  const auto written = mirrorarm::calibration::writePosePairs(argv[2], pairsOf(argv[1]));
  if (!written) throw std::runtime_error(written.error());
  return 0;
} catch (const std::exception& problem) {
  std::cerr << "convert_moveit_pairs: " << problem.what() << "\n";
  return 2;
}
