#include "tests/calibration/moveit_pairs.h"

#include <fstream>

#include <nlohmann/json.hpp>

namespace mirrorarm::calibration {
namespace {

RigidTransform pose(const nlohmann::json& rows) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix(row, column) = rows.at(row).at(column).get<double>();
  const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
  return makeTransform(Eigen::Quaterniond(R), matrix.topRightCorner<3, 1>());
}

}  // namespace

std::vector<PosePair> readMoveItPairs(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<PosePair> pairs;
  for (const auto& sample : nlohmann::json::parse(in))
    pairs.push_back({pose(sample.at(0)), pose(sample.at(1))});
  return pairs;
}

}  // namespace mirrorarm::calibration
