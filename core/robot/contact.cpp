#include "core/robot/contact.h"

namespace mirrorarm::robot {

std::string_view id(ArmPart part) {
  switch (part) {
    case ArmPart::kLink:
      return "link";
    case ArmPart::kCameraBar:
      return "camera_bar";
    case ArmPart::kSling:
      return "sling";
  }
  return "unknown";
}

std::string describe(const Contact& contact) {
  std::string line = std::string(id(contact.part)) + " meets ";
  if (!contact.obstacle) return line + "the arm";
  line += id(*contact.obstacle);
  if (!contact.name.empty()) line += " '" + contact.name + "'";
  return line;
}

}  // namespace mirrorarm::robot
