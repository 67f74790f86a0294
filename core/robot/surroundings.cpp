#include "core/robot/surroundings.h"

#include "core/common/yaml.h"

namespace mirrorarm::robot {
namespace {

constexpr double kFarthest_m = 20.0;  // from the base, and the longest side
constexpr std::size_t kMostObstacles = 64;

ObstacleKind kindIn(const YamlNode& node) {
  for (const ObstacleKind kind : {ObstacleKind::kBox, ObstacleKind::kTable, ObstacleKind::kHead})
    if (node.text() == id(kind)) return kind;
  node.refuse("is neither box nor table nor head");
}

double lengthIn(const YamlNode& node, bool may_be_zero) {
  const double length = node.number();
  if (length < 0.0 || length > kFarthest_m || (length == 0.0 && !may_be_zero))
    node.refuse("is not a length up to 20 m");
  return length;
}

RigidTransform poseIn(const YamlNode& node) {
  const Eigen::Vector3d centre = node["centre_m"].vector3();
  if (centre.norm() > kFarthest_m) node["centre_m"].refuse("is more than 20 m away from the robot");
  return makeTransform(
      node.has("rotation_xyzw") ? node["rotation_xyzw"].quaternion() : Eigen::Quaterniond::Identity(),
      centre);
}

Obstacle obstacleIn(const YamlNode& node) {
  node.allowOnly({"kind", "name", "centre_m", "rotation_xyzw", "size_m", "round_m", "radius_m"});
  Obstacle obstacle;
  obstacle.kind = kindIn(node["kind"]);
  obstacle.name = node["name"].text();
  obstacle.X_BO = poseIn(node);
  if (node.has("radius_m") == node.has("size_m"))
    node.refuse("needs either size_m (a box) or radius_m (a ball)");
  if (node.has("radius_m")) {
    if (node.has("round_m")) node["round_m"].refuse("belongs to a box");
    obstacle.size_m.setZero();
    obstacle.round_m = lengthIn(node["radius_m"], false);
    return obstacle;
  }
  for (int axis = 0; axis < 3; ++axis)
    obstacle.size_m[axis] = lengthIn(node["size_m"][static_cast<std::size_t>(axis)], false);
  if (node["size_m"].size() != 3) node["size_m"].refuse("does not hold three numbers");
  if (node.has("round_m")) obstacle.round_m = lengthIn(node["round_m"], true);
  return obstacle;
}

std::vector<Obstacle> obstaclesIn(const YamlNode& root) {
  root.allowOnly({"format", "obstacles"});
  const YamlNode list = root["obstacles"];
  if (list.size() > kMostObstacles) list.refuse("holds more than 64 obstacles");
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < list.size(); ++i) {
    obstacles.push_back(obstacleIn(list[i]));
    for (std::size_t j = 0; j < i; ++j)
      if (obstacles[j].name == obstacles[i].name) list[i]["name"].refuse("is there twice");
  }
  return obstacles;
}

}  // namespace

FromFile<std::vector<Obstacle>> readSurroundings(const std::filesystem::path& file) {
  return readYaml(file, "mirrorarm/surroundings/1", obstaclesIn);
}

}  // namespace mirrorarm::robot
