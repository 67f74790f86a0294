#include "core/robot/urdf.h"

#include <algorithm>
#include <cmath>
#include <console_bridge/console.h>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include <urdf_parser/urdf_parser.h>

namespace mirrorarm::robot {
namespace {

/// A joint or link of the file.
struct Place {
  std::string kind;
  std::string name;
};

/// Why a file is no arm; leaves this file as a FileError.
struct Refusal {
  std::string reason;
  Place place = {};
};

[[noreturn]] void refuse(const Place& place, const std::string& reason) {
  throw Refusal{place.kind + " '" + place.name + "': " + reason, place};
}

/// The line in which an element begins, 0 when it cannot be told.
int lineOf(const Place& place, const std::string& xml) {
  const auto at = xml.find("<" + place.kind + " name=\"" + place.name + "\"");
  if (place.kind.empty() || at == std::string::npos) return 0;
  return 1 + static_cast<int>(std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Takes what urdfdom says while it reads: the first complaint is the reason, nothing reaches the terminal.
class Complaints final : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = oneLine(text);
  }
  [[nodiscard]] std::string first() const { return first_.empty() ? "is not a URDF" : first_; }

 private:
  static std::string oneLine(std::string text) {
    for (char& letter : text)
      if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
    return text;
  }
  std::string first_;
};

Eigen::Vector3d toVector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

RigidTransform toTransform(const urdf::Pose& pose, const Place& place) {
  const Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  const Eigen::Vector3d p = toVector(pose.position);
  if (!p.allFinite() || !std::isfinite(q.norm()) || q.norm() < 0.5) refuse(place, "origin is not a pose");
  return makeTransform(q, p);
}

double positive(double number, const Place& place, const std::string& what) {
  if (!std::isfinite(number) || number <= 0.0) refuse(place, what + " must be a positive number");
  return number;
}

/// The half-length of the segment that a shape is swept along, and its radius.
struct Sweep {
  double half_length_m = 0.0;
  double radius_m = 0.0;
};

Sweep sweepOf(const urdf::Geometry& shape, const Place& place) {
  if (shape.type == urdf::Geometry::SPHERE)
    return {0.0, positive(static_cast<const urdf::Sphere&>(shape).radius, place, "sphere radius")};
  if (shape.type != urdf::Geometry::CYLINDER)
    refuse(place, "collision shape is neither a cylinder nor a sphere");
  const auto& cylinder = static_cast<const urdf::Cylinder&>(shape);
  return {positive(cylinder.length, place, "cylinder length") / 2.0,
          positive(cylinder.radius, place, "cylinder radius")};
}

/// Walks the chain and gathers the arm.
class ArmReader {
 public:
  explicit ArmReader(const urdf::ModelInterface& model) : links_(model.links_) {
    arm_.name = model.getName();
  }

  ArmDescription read(const urdf::Link& root) {
    visit(root);
    for (const urdf::Link* link = &root; !link->child_joints.empty();
         link = link->child_links.front().get()) {
      if (link->child_joints.size() != 1 || link->child_links.size() != 1)
        refuse({"link", link->name}, "has more than one child: an arm is one chain");
      addJoint(*link->child_joints.front());
      visit(*link->child_links.front());
    }
    for (const auto& [name, link] : links_)
      if (!visited_.contains(name)) refuse({"link", name}, "does not hang on the arm's chain");
    if (arm_.joints.empty()) throw Refusal{"has no turning joint"};
    arm_.X_last_F = X_joint_link_;
    return std::move(arm_);
  }

 private:
  void visit(const urdf::Link& link) {
    if (!visited_.insert(link.name).second)
      refuse({"link", link.name}, "hangs on itself: the chain is a ring");
    addShapes(link);
  }

  void addJoint(const urdf::Joint& joint) {
    const Place place{"joint", joint.name};
    X_joint_link_ = X_joint_link_ * toTransform(joint.parent_to_joint_origin_transform, place);
    if (joint.type == urdf::Joint::FIXED) return;
    if (joint.type != urdf::Joint::REVOLUTE) refuse(place, "only revolute and fixed joints can be used");
    if (joint.mimic) refuse(place, "a joint that mimics another cannot be used");
    if (arm_.jointCount() == kMaxJoints)
      refuse(place, "more than " + std::to_string(kMaxJoints) + " turning joints");
    arm_.joints.push_back(turningJoint(joint, place));
    X_joint_link_ = RigidTransform::Identity();
  }

  [[nodiscard]] JointDescription turningJoint(const urdf::Joint& joint, const Place& place) const {
    if (!joint.limits) refuse(place, "has no limits");
    JointDescription turning;
    turning.name = joint.name;
    turning.lower_rad = joint.limits->lower;
    turning.upper_rad = joint.limits->upper;
    if (!std::isfinite(turning.lower_rad) || !std::isfinite(turning.upper_rad) ||
        turning.lower_rad >= turning.upper_rad)
      refuse(place, "lower limit must be below the upper one");
    turning.max_speed_rad_s = positive(joint.limits->velocity, place, "velocity limit");
    turning.max_torque_nm = positive(joint.limits->effort, place, "effort limit");
    turning.X_parent = X_joint_link_;
    const Eigen::Vector3d axis = toVector(joint.axis);
    if (!axis.allFinite() || axis.norm() < 1e-6) refuse(place, "axis has no direction");
    turning.axis = axis.normalized();
    return turning;
  }

  void addShapes(const urdf::Link& link) {
    for (const auto& collision : link.collision_array) {
      const Place place{"link", link.name};
      if (!collision || !collision->geometry) refuse(place, "collision without geometry");
      const RigidTransform X = X_joint_link_ * toTransform(collision->origin, place);
      const Sweep sweep = sweepOf(*collision->geometry, place);
      const Eigen::Vector3d half = sweep.half_length_m * Eigen::Vector3d::UnitZ();
      arm_.shapes.push_back({arm_.jointCount(), X * Eigen::Vector3d(-half), X * half, sweep.radius_m});
    }
  }

  const std::map<std::string, urdf::LinkSharedPtr>& links_;
  std::set<std::string> visited_;
  ArmDescription arm_;
  RigidTransform X_joint_link_ =
      RigidTransform::Identity();  // the link at hand in the last turning joint's frame
};

ArmDescription parse(const std::string& xml) {
  const Complaints complaints;
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(xml);
  } catch (const std::exception& problem) {
    throw Refusal{"is not a URDF: " + std::string(problem.what())};
  }
  if (!model || !model->getRoot()) throw Refusal{complaints.first()};
  return ArmReader(*model).read(*model->getRoot());
}

}  // namespace

FromFile<ArmDescription> readUrdf(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) return unexpected(FileError{file, 0, "is missing"});
  if (!std::filesystem::is_regular_file(file, failed)) return unexpected(FileError{file, 0, "is not a file"});
  std::ifstream stream(file, std::ios::binary);
  const std::string xml{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return unexpected(FileError{file, 0, "cannot be read"});
  try {
    return parse(xml);
  } catch (const Refusal& refusal) {
    return unexpected(FileError{file, lineOf(refusal.place, xml), refusal.reason});
  }
}

}  // namespace mirrorarm::robot
