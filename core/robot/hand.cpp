#include "core/robot/hand.h"

#include "core/common/yaml.h"

namespace mirrorarm::robot {
namespace {

constexpr double kFarthest_m = 2.0;  // from the flange
constexpr double kThickest_m = 0.5;  // radius
constexpr std::size_t kMostShapes = 32;

Eigen::Vector3d placeIn(const YamlNode& node) {
  const Eigen::Vector3d place = node.vector3();
  if (place.norm() > kFarthest_m) node.refuse("is more than 2 m away from the flange");
  return place;
}

RigidTransform poseIn(const YamlNode& node) {
  node.allowOnly({"translation_m", "rotation_xyzw"});
  return makeTransform(node["rotation_xyzw"].quaternion(), placeIn(node["translation_m"]));
}

ArmPart partIn(const YamlNode& node) {
  for (const ArmPart part : {ArmPart::kCameraBar, ArmPart::kSling})
    if (node.text() == id(part)) return part;
  node.refuse("is neither camera_bar nor sling");
}

Capsule shapeIn(const YamlNode& node) {
  node.allowOnly({"part", "from_m", "to_m", "radius_m"});
  Capsule shape{0, placeIn(node["from_m"]), placeIn(node["to_m"]), node["radius_m"].number(),
                partIn(node["part"])};
  if (shape.radius_m <= 0.0 || shape.radius_m > kThickest_m)
    node["radius_m"].refuse("is not between 0 and 0.5");
  return shape;
}

Hand handIn(const YamlNode& root) {
  root.allowOnly({"format", "flange_from_camera", "flange_from_sling", "shapes"});
  Hand hand{poseIn(root["flange_from_camera"]), poseIn(root["flange_from_sling"]), {}};
  const YamlNode shapes = root["shapes"];
  if (shapes.size() > kMostShapes) shapes.refuse("holds more than 32 shapes");
  for (std::size_t i = 0; i < shapes.size(); ++i) hand.shapes_F.push_back(shapeIn(shapes[i]));
  return hand;
}

}  // namespace

FromFile<Hand> readHand(const std::filesystem::path& file) {
  return readYaml(file, "mirrorarm/hand/1", handIn);
}

std::vector<Capsule> attachedTo(const ArmDescription& arm, const Hand& hand) {
  std::vector<Capsule> shapes = hand.shapes_F;
  for (Capsule& shape : shapes) {
    shape.link = arm.jointCount();
    shape.a = arm.X_last_F * shape.a;
    shape.b = arm.X_last_F * shape.b;
  }
  return shapes;
}

}  // namespace mirrorarm::robot
