#include "core/therapy/movement_mapping.h"

#include <cassert>

namespace mirrorarm::therapy {
namespace {

RigidTransform followed(const Alignment& alignment, const RigidTransform& X_BT_now) {
  return X_BT_now * (alignment.X_BT.inverse() * alignment.X_BE);
}

RigidTransform mirrored(const Alignment& alignment, const RigidTransform& X_BT_now) {
  assert(alignment.midplane_normal_B.norm() > 0.0);
  const Eigen::Vector3d n = alignment.midplane_normal_B.normalized();
  const Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2.0 * n * n.transpose();
  const Eigen::Vector3d shift_B = X_BT_now.translation() - alignment.X_BT.translation();
  const Eigen::Matrix3d turn_B = X_BT_now.linear() * alignment.X_BT.linear().transpose();
  return makeTransform(Eigen::Matrix3d(reflection * turn_B * reflection * alignment.X_BE.linear()),
                       alignment.X_BE.translation() + reflection * shift_B);
}

}  // namespace

std::string_view id(Mapping mapping) { return mapping == Mapping::kFollow ? "follow" : "mirror"; }

std::optional<Mapping> mappingOf(std::string_view id_text) {
  for (const Mapping mapping : {Mapping::kFollow, Mapping::kMirror})
    if (id(mapping) == id_text) return mapping;
  return std::nullopt;
}

RigidTransform goalOf(const Alignment& alignment, Mapping mapping, const RigidTransform& X_BT_now) {
  return mapping == Mapping::kFollow ? followed(alignment, X_BT_now) : mirrored(alignment, X_BT_now);
}

}  // namespace mirrorarm::therapy
