#include "benchmarks/robot/bench_arm.h"

#include <stdexcept>

#include "core/common/resources.h"
#include "core/robot/hand.h"
#include "core/robot/urdf.h"

namespace mirrorarm::benchmarks::robot {

using namespace mirrorarm::robot;

ArmDescription lbr() {
  auto arm = readUrdf(resourceFolder() / "robots/lbr4plus.urdf");
  if (!arm) throw std::runtime_error(describe(arm.error()));
  return *arm;
}

std::vector<Capsule> handOn(const ArmDescription& arm) {
  const auto hand = readHand(resourceFolder() / "robots/hand.yaml");
  if (!hand) throw std::runtime_error(describe(hand.error()));
  return attachedTo(arm, *hand);
}

}  // namespace mirrorarm::benchmarks::robot
