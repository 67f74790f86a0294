#pragma once

#include <optional>
#include <string_view>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::therapy {

/// How the healthy arm's movement becomes the impaired arm's.
enum class Mapping {
  kFollow,  ///< the same movement in space: the end effector keeps its place in the target's frame (paper)
  kMirror,  ///< the movement reflected in the body's midplane
};
/// "follow", "mirror".
[[nodiscard]] std::string_view id(Mapping mapping);
[[nodiscard]] std::optional<Mapping> mappingOf(std::string_view id);

/// The virtual reference frame of the paper (section 2.4): the poses at the moment of aligning.
struct Alignment {
  RigidTransform X_BT = RigidTransform::Identity();              ///< target in robot base
  RigidTransform X_BE = RigidTransform::Identity();              ///< end effector (sling) in robot base
  Eigen::Vector3d midplane_normal_B = Eigen::Vector3d::UnitY();  ///< of the body's midplane, for the mirror
};

/// Where the end effector belongs when the target stands at `X_BT_now`: a pure function. In the mirror the
/// end effector is shifted by the reflected shift and turned in place by the reflected turn since aligning,
/// because where the midplane lies between the arms is not known. `midplane_normal_B` need not be of unit
/// length, but not zero.
[[nodiscard]] RigidTransform goalOf(const Alignment& alignment, Mapping mapping,
                                    const RigidTransform& X_BT_now);

}  // namespace mirrorarm::therapy
